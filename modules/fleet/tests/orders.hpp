#pragma once

#include <string>
#include <vector>

#include "aisle/fleet/order_tracker.hpp"

namespace aisle {

/// Node "n<i>" at (2 i, 0), as the orders below use them.
inline OrderNode node_at(std::uint32_t i, bool released = true) {
  OrderNode node;
  node.id = "n" + std::to_string(i);
  node.sequence = 2 * i;
  node.released = released;
  node.p_map = Vec2(2.0 * i, 0);
  return node;
}

/// Nodes n<first> to n<last>, those up to n<base> released.
inline Order order_along(std::uint32_t first, std::uint32_t base, std::uint32_t last,
                         std::uint32_t update = 0, const std::string& id = "order") {
  Order order;
  order.id = id;
  order.update_id = update;
  for (std::uint32_t i = first; i <= last; ++i) {
    order.nodes.push_back(node_at(i, i <= base));
    if (i == first) continue;
    OrderEdge edge;
    edge.from = "n" + std::to_string(i - 1);
    edge.to = "n" + std::to_string(i);
    edge.id = edge.from + edge.to;
    edge.sequence = 2 * i - 1;
    edge.released = i <= base;
    order.edges.push_back(edge);
  }
  return order;
}

inline FleetAction wait_action(const std::string& id, double duration_s) {
  return {.type = "wait", .id = id, .parameters = {{"duration", duration_s}}};
}

inline FleetAction instant(const std::string& type, const std::string& id) {
  return {.type = type, .id = id, .parameters = {}};
}

/// Knows no nodes by itself; y above 5 is in a wall.
inline OrderTracker straight_tracker() {
  return OrderTracker({"hall", [](const std::string&) { return std::optional<Vec2>(); },
                       [](const Vec2& p) { return std::string(p.y() > 5 ? "is in a wall" : ""); }},
                      0.5);
}

}  // namespace aisle
