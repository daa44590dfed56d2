#include <gtest/gtest.h>

#include "corridor_graphs.hpp"

namespace aisle {
namespace {

/// A T: along x from (0, 0) to (10, 0), a branch at (4, 0) up to (4, 3).
CorridorGraph t_graph() {
  return straight_graph({{0, 0}, {4, 0}, {10, 0}, {4, 3}}, {{0, 1}, {1, 2}, {3, 1}});
}

TEST(CorridorGraph, LengthsAddUp) {
  EXPECT_DOUBLE_EQ(t_graph().length_m(), 13);
  EXPECT_EQ(CorridorGraph{}.length_m(), 0);
}

TEST(CorridorGraph, ALoopCorridorEndsTwiceAtItsNode) {
  CorridorGraph graph = t_graph();
  graph.corridors.push_back({2, 2, {{10, 0}, {12, 0}, {12, 2}, {10, 0}}, 2});
  EXPECT_EQ(graph.degree(0), 1U);
  EXPECT_EQ(graph.degree(1), 3U);
  EXPECT_EQ(graph.degree(2), 3U);
}

TEST(CorridorGraph, ThePlaceNearestToAPointIsFoundOnThePathAndItsDistance) {
  const auto place = t_graph().nearest({4.5, 2});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->corridor, 2U);
  EXPECT_DOUBLE_EQ(place->along_m, 1);
  EXPECT_DOUBLE_EQ(place->lateral_m, 0.5);
  EXPECT_FALSE(CorridorGraph{}.nearest({0, 0}));
}

TEST(CorridorGraph, PointsAlongACorridorStayOnIt) {
  const Corridor bent{0, 1, {{0, 0}, {2, 0}, {2, 5}}, 2};
  EXPECT_EQ(bent.at(1), Vec2(1, 0));
  EXPECT_EQ(bent.at(3), Vec2(2, 1));
  EXPECT_EQ(bent.at(99), Vec2(2, 5));
  EXPECT_EQ(bent.at(-1), Vec2(0, 0));
}

TEST(CorridorGraph, ANodeIsAPlaceAtTheEndOfOneOfItsCorridors) {
  const CorridorGraph graph = t_graph();
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    const auto place = graph.place_of(node);
    ASSERT_TRUE(place);
    EXPECT_EQ(graph.corridors[place->corridor].at(place->along_m), graph.nodes[node].p_map);
  }
}

TEST(CorridorGraph, NodesAreNamedByKindAndOrder) {
  CorridorGraph graph = t_graph();
  graph.nodes[0].kind = graph.nodes[3].kind = CorridorNode::Kind::kEnd;
  EXPECT_EQ(graph.name_of(0), "end 1");
  EXPECT_EQ(graph.name_of(1), "crossing 1");
  EXPECT_EQ(graph.name_of(2), "crossing 2");
  EXPECT_EQ(graph.name_of(3), "end 2");
}

}  // namespace
}  // namespace aisle
