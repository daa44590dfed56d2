#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

namespace aisle {
namespace {

constexpr std::size_t kNodesMax = 100'000;
constexpr std::size_t kCorridorsMax = 100'000;
constexpr std::size_t kPlacesMax = 10'000;
constexpr Range kCorridorWidth_m = {0, 1000}, kPathLength_m = {0, 100'000};
constexpr Digits kCentimetres = {2};
constexpr int kHeadingDecimals = 3;
constexpr double kOffNodeMax_m = 0.002;
constexpr double kLengthOffMax_m = 0.05;
constexpr std::array<std::string_view, 3> kNodeKinds = {"crossing", "end", "round"};

JsonFields node_fields(CorridorNode& node) {
  return {needed(field::word("kind", node.kind, kNodeKinds)),
          needed(field::point("at_m", node.p_map, kMapCoordinate_m))};
}

JsonPart node_index_part(std::string_view key, std::size_t& node, const std::vector<CorridorNode>& nodes) {
  return {key, [&node] { return std::to_string(node); },
          [&node, &nodes](const JsonValue& value) {
            if (nodes.empty()) return value.wrong("is no node: there are none");
            int index = 0;
            value.read_count(index, {0, static_cast<double>(nodes.size() - 1)});
            node = static_cast<std::size_t>(index);
          }};
}

/// @param length_m  of the path  @param nodes  of its graph
JsonFields corridor_fields(Corridor& corridor, double& length_m, const std::vector<CorridorNode>& nodes) {
  return {needed(node_index_part("from", corridor.from, nodes)),
          needed(node_index_part("to", corridor.to, nodes)),
          field::number("length_m", length_m, kPathLength_m, kCentimetres),
          needed(field::number("width_m", corridor.width_m, kCorridorWidth_m, kCentimetres)),
          needed(field::points("path_m", corridor.path, kMapCoordinate_m))};
}

/// The length is that of the path as it is written, with its points rounded.
std::string corridor_json(Corridor corridor, const std::vector<CorridorNode>& nodes) {
  constexpr double kPerMetre = 1000;
  for (Vec2& p : corridor.path) p = (p * kPerMetre).array().round() / kPerMetre;
  double length_m = corridor.length_m();
  return object_json(corridor_fields(corridor, length_m, nodes));
}

void check_corridor(const Corridor& corridor, double length_m, const std::vector<CorridorNode>& nodes,
                    const JsonValue& value) {
  const auto path = value.find("path_m");
  if (!path) return;
  if (corridor.path.size() < 2) return path->wrong("has less than two points");
  const auto is_at = [&](const Vec2& p, std::size_t node) {
    return node < nodes.size() && (p - nodes[node].p_map).norm() <= kOffNodeMax_m;
  };
  if (!is_at(corridor.path.front(), corridor.from) || !is_at(corridor.path.back(), corridor.to))
    path->wrong("does not lead from the node `from` to the node `to`");
  const auto length = value.find("length_m");
  if (length && std::abs(length_m - corridor.length_m()) > kLengthOffMax_m)
    length->wrong(fmt::format("is not the length of the path, {:.2f}", corridor.length_m()));
}

Corridor read_corridor(const JsonValue& value, const std::vector<CorridorNode>& nodes) {
  Corridor corridor;
  double length_m = std::nan("");  // until it is read
  if (read_object(value, corridor_fields(corridor, length_m, nodes)))
    check_corridor(corridor, length_m, nodes, value);
  return corridor;
}

JsonFields graph_fields(CorridorGraph& graph) {
  const std::vector<CorridorNode>& nodes = graph.nodes;
  return {needed(objects_part("nodes", graph.nodes, kNodesMax, node_fields)),
          needed(list_part(
              "corridors", graph.corridors, kCorridorsMax,
              [&nodes](const Corridor& corridor) { return corridor_json(corridor, nodes); },
              [&nodes](const JsonValue& value) { return read_corridor(value, nodes); }))};
}

/// Left out where the place has none.
JsonPart place_heading_part(MapPlace& place) {
  JsonPart part = heading_part("heading_deg", place.T_map_place.theta, kHeadingDecimals);
  part.text = [&place, text = std::move(part.text)] { return place.has_heading ? text() : ""; };
  part.read = [&place, read = std::move(part.read)](const JsonValue& value) {
    place.has_heading = true;
    read(value);
  };
  return part;
}

JsonFields place_fields(MapPlace& place) {
  Pose2& T_map_place = place.T_map_place;
  return {needed(field::text("name", place.name)),
          needed(field::point("at_m", T_map_place.x, T_map_place.y, kMapCoordinate_m)),
          place_heading_part(place)};
}

MapPlace read_place(const JsonValue& value) {
  MapPlace place{.name = {}, .T_map_place = {}, .has_heading = false};
  read_object(value, place_fields(place));
  return place;
}

}  // namespace

JsonPart corridors_part(std::string_view key, CorridorGraph& graph) {
  JsonPart part = object_part(key, graph, graph_fields);
  part.text = [&graph, text = std::move(part.text)] { return graph.nodes.empty() ? "" : text(); };
  return part;
}

JsonPart places_part(std::string_view key, std::vector<MapPlace>& places) {
  JsonPart part = list_part(
      key, places, kPlacesMax, [](MapPlace& place) { return object_json(place_fields(place)); }, read_place);
  part.read = [&places, read = std::move(part.read)](const JsonValue& value) {
    read(value);
    std::set<std::string> names;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string& name = places[i].name;
      if (!name.empty() && !names.insert(name).second)
        value.element(i).wrong(fmt::format("has the name of another place, '{}'", name));
    }
  };
  return part;
}

}  // namespace aisle
