#include "aisle/fleet/fleet_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/geometry/segment2.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStraight_m = 0.15;    // as far a straight edge may leave the corridor's centre line
constexpr double kFloorEvery_m = 0.05;  // looked at between a place and its node
constexpr const char* kVehicleType = "aisle";

/// The points that a polyline cannot do without (Douglas and Peucker).
void add_bends(std::span<const Vec2> points, std::vector<Vec2>& bends) {
  const Segment2 chord{points.front(), points.back()};
  double farthest_m = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double off_m = chord.distance(points[i]);
    if (off_m > farthest_m) {
      farthest_m = off_m;
      at = i;
    }
  }
  const bool is_loop = (points.back() - points.front()).norm() < kStraight_m && points.size() > 2;
  if (farthest_m > kStraight_m || (is_loop && farthest_m > 0)) {
    add_bends(points.subspan(0, at + 1), bends);
    add_bends(points.subspan(at), bends);
  } else {
    bends.push_back(points.back());
  }
}

std::vector<Vec2> spaced_points(const std::vector<Vec2>& path, double spacing_m) {
  std::vector<Vec2> bends{path.front()};
  add_bends(path, bends);
  std::vector<Vec2> points{path.front()};
  for (std::size_t i = 1; i < bends.size(); ++i) {
    const Vec2 step = bends[i] - bends[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(step.norm() / spacing_m)));
    for (int k = 1; k <= parts; ++k) points.push_back(bends[i - 1] + step * (static_cast<double>(k) / parts));
  }
  return points;
}

class GraphMaker {
 public:
  GraphMaker(const Building& building, double spacing_m) : building_(building), spacing_m_(spacing_m) {}

  FleetGraph make() {
    const CorridorGraph& corridors = building_.corridors;
    for (std::size_t i = 0; i < corridors.nodes.size(); ++i)
      ends_.push_back(add_node(corridors.name_of(i), corridors.nodes[i].p_map));
    for (std::size_t i = 0; i < corridors.corridors.size(); ++i) add_corridor(i);
    const std::size_t corridor_nodes = graph_.nodes.size();
    for (const MapPlace& place : building_.places) add_place(place, corridor_nodes);
    return std::move(graph_);
  }

 private:
  /// nullopt: it lies in a keep-out zone.
  std::optional<std::size_t> add_node(std::string id, const Vec2& p_map) {
    if (keep_out_around(building_.zones, p_map) != nullptr) return std::nullopt;
    graph_.nodes.push_back({std::move(id), p_map});
    return graph_.nodes.size() - 1;
  }

  void add_corridor(std::size_t i) {
    const Corridor& corridor = building_.corridors.corridors[i];
    const std::vector<Vec2> points = spaced_points(corridor.path, spacing_m_);
    std::optional<std::size_t> from = ends_[corridor.from];
    for (std::size_t k = 1; k < points.size(); ++k) {
      const bool is_last = k + 1 == points.size();
      const auto to =
          is_last ? ends_[corridor.to] : add_node(fmt::format("corridor {}.{}", i + 1, k), points[k]);
      if (from && to) join(*from, *to);
      from = to;
    }
  }

  bool is_against_one_way(const Vec2& from, const Vec2& to) const {
    const double heading_rad = heading_of(to - from);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec2 p = from + share * (to - from);
      if (one_way_against(building_.zones, {p.x(), p.y(), heading_rad}, Gear::kForward) != nullptr)
        return true;
    }
    return false;
  }

  void join(std::size_t a, std::size_t b) {
    add_edge(a, b);
    add_edge(b, a);
  }

  void add_edge(std::size_t from, std::size_t to) {
    const FleetNode &start = graph_.nodes[from], &end = graph_.nodes[to];
    if (is_against_one_way(start.p_map, end.p_map)) return;
    std::string id = fmt::format("{} - {}", start.id, end.id);
    // Two corridors may join the same two crossings.
    if (const int n = ++edges_[id]; n > 1) id += fmt::format(" ({})", n);
    graph_.edges.push_back({std::move(id), from, to});
  }

  bool is_free_between(const Vec2& from, const Vec2& to) const {
    if (!building_.floor) return false;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kFloorEvery_m)));
    for (int k = 0; k <= steps; ++k) {
      const Vec2 p = from + (to - from) * (static_cast<double>(k) / steps);
      if (building_.floor->at(p) != Floor::kFree) return false;
    }
    return true;
  }

  void add_place(const MapPlace& place, std::size_t corridor_nodes) {
    const Vec2 p_map = place.T_map_place.position();
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < corridor_nodes; ++i) {
      const double off_m = (graph_.nodes[i].p_map - p_map).norm();
      if (nearest && off_m >= (graph_.nodes[*nearest].p_map - p_map).norm()) continue;
      if (is_free_between(graph_.nodes[i].p_map, p_map)) nearest = i;
    }
    if (!nearest) return;
    const auto node = add_node(place.name, p_map);
    if (!node) return;
    join(*nearest, *node);
    const auto heading_rad = place.has_heading ? std::optional(place.T_map_place.theta) : std::nullopt;
    graph_.stations.push_back({place.name, *node, p_map, heading_rad});
  }

  const Building& building_;
  double spacing_m_;
  FleetGraph graph_;
  std::vector<std::optional<std::size_t>> ends_;  ///< of each node of the corridors
  std::map<std::string, int> edges_;
};

Json lif_node(const FleetNode& node, const std::string& map_id) {
  return {{"nodeId", node.id},
          {"nodeName", node.id},
          {"mapId", map_id},
          {"nodePosition", {{"x", rounded(node.p_map.x(), 3)}, {"y", rounded(node.p_map.y(), 3)}}},
          {"vehicleTypeNodeProperties", Json::array({{{"vehicleTypeId", kVehicleType}}})}};
}

Json lif_edge(const FleetEdge& edge, const FleetGraph& graph) {
  return {{"edgeId", edge.id},
          {"edgeName", edge.id},
          {"startNodeId", graph.nodes[edge.from].id},
          {"endNodeId", graph.nodes[edge.to].id},
          {"vehicleTypeEdgeProperties", Json::array({{{"vehicleTypeId", kVehicleType},
                                                      {"vehicleOrientation", 0},
                                                      {"orientationType", "TANGENTIAL"},
                                                      {"rotationAllowed", true},
                                                      {"reentryAllowed", true}}})}};
}

Json lif_station(const FleetStation& station, const FleetGraph& graph) {
  Json position = {{"x", rounded(station.p_map.x(), 3)}, {"y", rounded(station.p_map.y(), 3)}};
  if (station.heading_rad) position["theta"] = rounded(*station.heading_rad, 4);
  return {{"stationId", station.name},
          {"stationName", station.name},
          {"interactionNodeIds", Json::array({graph.nodes[station.node].id})},
          {"stationPosition", std::move(position)}};
}

}  // namespace

std::optional<Vec2> FleetGraph::find(const std::string& node_id) const {
  const auto found =
      std::find_if(nodes.begin(), nodes.end(), [&](const FleetNode& node) { return node.id == node_id; });
  return found == nodes.end() ? std::nullopt : std::optional(found->p_map);
}

FleetGraph fleet_graph(const Building& building, double spacing_m) {
  return GraphMaker(building, spacing_m).make();
}

std::string lif_json(const FleetGraph& graph, const Building& building, const std::string& timestamp) {
  Json layout = {{"layoutId", building.name}, {"layoutName", building.name}, {"layoutVersion", "1"},
                 {"nodes", Json::array()},    {"edges", Json::array()},      {"stations", Json::array()}};
  for (const FleetNode& node : graph.nodes) layout["nodes"].push_back(lif_node(node, building.name));
  for (const FleetEdge& edge : graph.edges) layout["edges"].push_back(lif_edge(edge, graph));
  for (const FleetStation& station : graph.stations)
    layout["stations"].push_back(lif_station(station, graph));
  const Json lif = {{"metaInformation",
                     {{"projectIdentification", building.name},
                      {"creator", "aisle"},
                      {"exportTimestamp", timestamp},
                      {"lifVersion", "1.0.0"}}},
                    {"layouts", Json::array({std::move(layout)})}};
  return lif.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aisle
