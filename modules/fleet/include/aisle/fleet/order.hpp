#pragma once
/// What a fleet's master control asks of a vehicle, by VDA 5050 version 2.1: orders and instant actions.

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Something to do besides driving.
struct FleetAction {
  enum class Blocking {
    kNone,  ///< beside driving and other actions
    kSoft,  ///< beside other actions, while the vehicle stands
    kHard,  ///< alone, while the vehicle stands
  };
  std::string type;
  std::string id;  ///< unique; states name it
  Blocking blocking = Blocking::kHard;
  std::map<std::string, nlohmann::json> parameters;

  friend bool operator==(const FleetAction&, const FleetAction&) = default;
};

struct OrderNode {
  std::string id;
  std::uint32_t sequence = 0;  ///< even; counts nodes and edges of the whole order
  bool released = false;       ///< in the base; else in the horizon, which is never driven
  std::optional<Vec2> p_map;   ///< absent: the vehicle knows the node
  std::optional<double> heading_rad;
  double deviation_m = 0;               ///< how far off it counts as reached
  std::optional<double> deviation_rad;  ///< the same of its heading
  std::string map_id;                   ///< of `p_map`; empty: not given
  std::vector<FleetAction> actions;

  friend bool operator==(const OrderNode&, const OrderNode&) = default;
};

struct OrderEdge {
  std::string id;
  std::uint32_t sequence = 0;  ///< odd
  bool released = false;
  std::string from, to;  ///< nodes
  std::optional<double> speed_max_mps;
  std::vector<FleetAction> actions;

  friend bool operator==(const OrderEdge&, const OrderEdge&) = default;
};

/// Nodes and edges in turn, one node more than edges, first what is released.
struct Order {
  std::string id;
  std::uint32_t update_id = 0;
  std::string zone_set_id;
  std::vector<OrderNode> nodes;  ///< at least one, the first of them released
  std::vector<OrderEdge> edges;

  friend bool operator==(const Order&, const Order&) = default;
};

}  // namespace aisle
