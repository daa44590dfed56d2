#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "aisle/fleet/fleet_graph.hpp"

namespace aisle {
namespace {

/// A corridor of 9 m that bends once, with a place beside it.
Building bent_building() {
  Building building;
  building.name = "hall";
  building.corridors.nodes = {{CorridorNode::Kind::kEnd, {0, 0}}, {CorridorNode::Kind::kEnd, {6, 3}}};
  building.corridors.corridors = {{0, 1, {{0, 0}, {3, 0}, {6, 0}, {6, 3}}, 2}};
  building.places = {{"desk", {0, 0.8, kPi / 2}}, {"vault", {3, 5, 0}}};
  FloorGrid floor(0.1);
  for (double x = -1; x < 7; x += 0.1) {
    for (double y = -1; y < 4; y += 0.1) floor.set(floor.cell_at({x, y}), Floor::kFree);
  }
  building.floor = floor;
  return building;
}

std::vector<std::string> node_ids(const FleetGraph& graph) {
  std::vector<std::string> ids;
  for (const FleetNode& node : graph.nodes) ids.push_back(node.id);
  return ids;
}

TEST(FleetGraph, CorridorsAreStraightEdgesBothWays) {
  const FleetGraph graph = fleet_graph(bent_building(), 4);
  EXPECT_THAT(node_ids(graph),
              testing::ElementsAre("end 1", "end 2", "corridor 1.1", "corridor 1.2", "desk"));
  EXPECT_EQ(*graph.find("corridor 1.1"), Vec2(3, 0));
  EXPECT_EQ(*graph.find("corridor 1.2"), Vec2(6, 0));
  EXPECT_FALSE(graph.find("vault")) << "nothing leads there";
  EXPECT_THAT(graph.edges, testing::SizeIs(8));
}

TEST(FleetGraph, ZonesAreObeyed) {
  Building building = bent_building();
  building.zones = {
      {.kind = Zone::Kind::kOneWay, .name = "", .outline = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}}},
      {.kind = Zone::Kind::kKeepOut, .name = "", .outline = {{5, 2}, {7, 2}, {7, 4}, {5, 4}}}};
  const FleetGraph graph = fleet_graph(building, 4);
  std::vector<std::string> edges;
  for (const FleetEdge& edge : graph.edges) edges.push_back(edge.id);
  EXPECT_THAT(edges, testing::Contains("end 1 - corridor 1.1"));
  EXPECT_THAT(edges, testing::Not(testing::Contains("corridor 1.1 - end 1")));
  EXPECT_FALSE(graph.find("end 2"));
}

TEST(FleetGraph, IsWrittenAsLif) {
  const Building building = bent_building();
  const auto lif = nlohmann::json::parse(lif_json(fleet_graph(building), building, "2026-01-31T12:00:00Z"));
  EXPECT_EQ(lif["metaInformation"]["lifVersion"], "1.0.0");
  const auto& layout = lif["layouts"][0];
  EXPECT_EQ(layout["nodes"].size(), 5U);
  EXPECT_EQ(layout["edges"][0]["startNodeId"], "end 1");
  EXPECT_EQ(layout["stations"][0]["interactionNodeIds"][0], "desk");
  EXPECT_EQ(layout["stations"][0]["stationPosition"],
            nlohmann::json({{"x", 0.0}, {"y", 0.8}, {"theta", 1.5708}}));
}

TEST(FleetGraph, APlaceWithoutAHeadingIsAStationWithoutOne) {
  Building building = bent_building();
  building.places[0] = {.name = "desk", .T_map_place = {0, 0.8, 0}, .has_heading = false};
  const auto lif = nlohmann::json::parse(lif_json(fleet_graph(building), building, "2026-01-31T12:00:00Z"));
  EXPECT_EQ(lif["layouts"][0]["stations"][0]["stationPosition"], nlohmann::json({{"x", 0.0}, {"y", 0.8}}));
}

}  // namespace
}  // namespace aisle
