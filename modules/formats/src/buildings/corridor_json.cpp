#include "buildings/corridor_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "aisle/core/angle.hpp"
#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr const char* kFormerPathKey = "way_m";  // in versions 1 and 2

constexpr std::size_t kNodesMax = 100'000;
constexpr std::size_t kCorridorsMax = 100'000;
constexpr std::size_t kPathPointsMax = 100'000;
constexpr std::size_t kPlacesMax = 10'000;
constexpr double kWidthMax_m = 1000;
constexpr double kLengthMax_m = 100'000;
constexpr double kOffNodeMax_m = 0.002;
constexpr double kLengthOffMax_m = 0.05;

constexpr CorridorNode::Kind kNodeKinds[] = {CorridorNode::Kind::kCrossing, CorridorNode::Kind::kEnd,
                                             CorridorNode::Kind::kRound};

std::string node_json(const CorridorNode& node) {
  return fmt::format(R"({{"kind": "{}", "at_m": {}}})", name_of(node.kind),
                     point_json(node.p_map, kMillimetreDecimals));
}

/// The length is that of the path as it is written, with its points rounded.
std::string corridor_json(const Corridor& corridor) {
  constexpr double kPerMetre = 1000;
  std::vector<std::string> points;
  Corridor written = corridor;
  for (Vec2& p : written.path) {
    points.push_back(point_json(p, kMillimetreDecimals));
    p = (p * kPerMetre).array().round() / kPerMetre;
  }
  return fmt::format(R"({{"from": {}, "to": {}, "length_m": {}, "width_m": {}, "path_m": [{}]}})",
                     corridor.from, corridor.to, decimals(written.length_m(), 2),
                     decimals(corridor.width_m, 2), fmt::join(points, ", "));
}

CorridorNode read_node(const JsonValue& value) {
  CorridorNode node;
  if (!value.is_object_of({"kind", "at_m"})) return node;
  if (const auto at = value.require("at_m")) at->read_point(node.p_map);
  const auto kind = value.require("kind");
  if (!kind) return node;
  for (const CorridorNode::Kind known : kNodeKinds) {
    if (!kind->is(name_of(known))) continue;
    node.kind = known;
    return node;
  }
  kind->wrong(R"(is none of "crossing", "end" and "round")");
  return node;
}

std::vector<Vec2> read_path(const JsonValue& value) {
  std::vector<Vec2> path;
  if (!value.is_list_up_to(kPathPointsMax)) return path;
  for (std::size_t i = 0; i < value.size(); ++i) value.element(i).read_point(path.emplace_back(0, 0));
  return path;
}

std::size_t read_node_index(const JsonValue& corridor, const char* key, std::size_t nodes) {
  int index = 0;
  if (const auto value = corridor.require(key)) value->read_count(index, 0, static_cast<int>(nodes) - 1);
  return static_cast<std::size_t>(index);
}

Corridor read_corridor(const JsonValue& value, const std::vector<CorridorNode>& nodes) {
  Corridor corridor;
  if (!value.is_object_of({"from", "to", "length_m", "width_m", "path_m", kFormerPathKey})) return corridor;
  corridor.from = read_node_index(value, "from", nodes.size());
  corridor.to = read_node_index(value, "to", nodes.size());
  if (const auto width = value.require("width_m")) width->read_number(corridor.width_m, 0, kWidthMax_m);
  const auto former_path = value.find(kFormerPathKey);
  const auto path = former_path ? former_path : value.require("path_m");
  if (!path) return corridor;
  if (former_path && value.find("path_m")) {
    former_path->wrong("is the former name of `path_m`, which is there too: one of them is needed");
    return corridor;
  }
  corridor.path = read_path(*path);
  if (corridor.path.size() < 2) {
    path->wrong("has less than two points");
    return corridor;
  }
  const auto is_at = [&](const Vec2& p, std::size_t node) {
    return node < nodes.size() && (p - nodes[node].p_map).norm() <= kOffNodeMax_m;
  };
  if (!is_at(corridor.path.front(), corridor.from) || !is_at(corridor.path.back(), corridor.to))
    path->wrong("does not lead from the node `from` to the node `to`");
  double length_m = corridor.length_m();
  const auto length = value.find("length_m");
  if (length) length->read_number(length_m, 0, kLengthMax_m);
  if (std::abs(length_m - corridor.length_m()) > kLengthOffMax_m)
    length->wrong(fmt::format("is not the length of the path, {:.2f}", corridor.length_m()));
  return corridor;
}

MapPlace read_place(const JsonValue& value) {
  MapPlace place;
  if (!value.is_object_of({"name", "at_m", "heading_deg"})) return place;
  Vec2 p_map = Vec2::Zero();
  double heading_deg = 0;
  if (const auto name = value.require("name")) name->read_name(place.name);
  if (const auto at = value.require("at_m")) at->read_point(p_map);
  if (const auto heading = value.find("heading_deg")) heading->read_number(heading_deg, -360, 360);
  place.T_map_place = {p_map.x(), p_map.y(), wrap_angle(heading_deg * kDegree)};
  return place;
}

}  // namespace

std::string corridors_json(const CorridorGraph& graph) {
  std::vector<std::string> nodes, corridors;
  for (const CorridorNode& node : graph.nodes) nodes.push_back(node_json(node));
  for (const Corridor& corridor : graph.corridors) corridors.push_back(corridor_json(corridor));
  return fmt::format(R"({{"nodes": {}, "corridors": {}}})", list_json(nodes), list_json(corridors));
}

CorridorGraph read_corridors(const JsonValue& value) {
  CorridorGraph graph;
  if (!value.is_object_of({"nodes", "corridors"})) return graph;
  const auto nodes = value.require("nodes"), corridors = value.require("corridors");
  if (!nodes || !corridors || !nodes->is_list_up_to(kNodesMax) || !corridors->is_list_up_to(kCorridorsMax))
    return graph;
  for (std::size_t i = 0; i < nodes->size(); ++i) graph.nodes.push_back(read_node(nodes->element(i)));
  for (std::size_t i = 0; i < corridors->size(); ++i)
    graph.corridors.push_back(read_corridor(corridors->element(i), graph.nodes));
  return graph;
}

std::string places_json(const std::vector<MapPlace>& places) {
  std::vector<std::string> texts;
  texts.reserve(places.size());
  for (const MapPlace& place : places) {
    texts.push_back(fmt::format(R"({{"name": {}, "at_m": {}, "heading_deg": {}}})", quoted_json(place.name),
                                point_json(place.T_map_place.position(), kMillimetreDecimals),
                                decimals(to_degrees(place.T_map_place.theta), 3)));
  }
  return list_json(texts);
}

std::vector<MapPlace> read_places(const JsonValue& value) {
  std::vector<MapPlace> places;
  if (!value.is_list_up_to(kPlacesMax)) return places;
  std::set<std::string> names;
  for (std::size_t i = 0; i < value.size(); ++i) {
    places.push_back(read_place(value.element(i)));
    const std::string& name = places.back().name;
    if (!name.empty() && !names.insert(name).second)
      value.element(i).wrong(fmt::format("has the name of another place, '{}'", name));
  }
  return places;
}

}  // namespace aisle
