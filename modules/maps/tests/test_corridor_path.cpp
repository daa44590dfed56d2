#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "aisle/geometry/polyline.hpp"
#include "aisle/maps/corridor_path.hpp"
#include "corridor_graphs.hpp"

namespace aisle {
namespace {

/// A square of 10 m with its corners as crossings, the first corridor along x from the origin.
CorridorGraph square_graph() {
  return straight_graph({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

/// All distances between nodes by Floyd and Warshall.
std::vector<std::vector<double>> all_distances(const CorridorGraph& graph) {
  const std::size_t n = graph.nodes.size();
  std::vector d(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < n; ++i) d[i][i] = 0;
  for (const Corridor& c : graph.corridors) {
    d[c.from][c.to] = std::min(d[c.from][c.to], c.length_m());
    d[c.to][c.from] = d[c.from][c.to];
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
    }
  }
  return d;
}

TEST(CorridorPath, OnOneCorridorThePathIsThePieceBetween) {
  const CorridorGraph graph = square_graph();
  const auto path = shortest_path(graph, *graph.nearest({8, 0}), *graph.nearest({2, 1}));
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length_m(), 6);
  EXPECT_EQ(path->points(graph), (std::vector<Vec2>{{8, 0}, {2, 0}}));
}

TEST(CorridorPath, ItTakesTheShorterSideOfALoop) {
  const CorridorGraph graph = square_graph();
  const auto path = shortest_path(graph, *graph.nearest({8, 0}), *graph.nearest({7, 10}));
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length_m(), 2 + 10 + 3);
  EXPECT_EQ(path->points(graph), (std::vector<Vec2>{{8, 0}, {10, 0}, {10, 10}, {7, 10}}));
}

TEST(CorridorPath, AClosedPlaceIsAvoided) {
  const CorridorGraph graph = square_graph();
  const std::vector<CorridorPlace> closed = {*graph.nearest({10, 5})};
  const auto path = shortest_path(graph, *graph.nearest({8, 0}), *graph.nearest({7, 10}), closed);
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length_m(), 8 + 10 + 7);
}

TEST(CorridorPath, ThePathLeadsAroundFromOneSideOfAClosedPlaceToTheOther) {
  const CorridorGraph graph = square_graph();
  const std::vector<CorridorPlace> closed = {*graph.nearest({5, 0})};
  const auto path = shortest_path(graph, *graph.nearest({4, 0}), *graph.nearest({6, 0}), closed);
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length_m(), 4 + 30 + 4);
}

TEST(CorridorPath, ThereIsNoneToADisconnectedPlace) {
  const CorridorGraph graph = square_graph();
  const std::vector<CorridorPlace> closed = {*graph.nearest({5, 0}), *graph.nearest({10, 5})};
  EXPECT_FALSE(shortest_path(graph, *graph.nearest({0, 2}), *graph.nearest({9, 0}), closed));
}

RC_GTEST_PROP(CorridorPath, NodesAreAsFarApartAsBetweenAllPairsTriedTogether, (std::uint64_t seed)) {
  Random random(seed);
  const CorridorGraph graph = any_graph(random, 2 + random.index(9), random.index(8));
  const auto distances = all_distances(graph);
  const std::size_t a = random.index(graph.nodes.size()), b = random.index(graph.nodes.size());
  const auto path = shortest_path(graph, *graph.place_of(a), *graph.place_of(b));
  RC_ASSERT(path.has_value());
  RC_ASSERT(std::abs(path->length_m() - distances[a][b]) < 1e-9);
  const std::vector<Vec2> points = path->points(graph);
  RC_ASSERT((points.front() - graph.nodes[a].p_map).norm() < 1e-9);
  RC_ASSERT((points.back() - graph.nodes[b].p_map).norm() < 1e-9);
}

RC_GTEST_PROP(CorridorPath, ItsPointsAreAsLongAsItsLegsFromPlaceToPlace, (std::uint64_t seed)) {
  Random random(seed);
  const CorridorGraph graph = any_graph(random, 2 + random.index(9), random.index(8));
  const auto any_place = [&] {
    const std::size_t i = random.index(graph.corridors.size());
    const double along_m = random.uniform(0, graph.corridors[i].length_m());
    return CorridorPlace{i, along_m, graph.corridors[i].at(along_m), 0};
  };
  const CorridorPlace from = any_place(), to = any_place();
  const auto path = shortest_path(graph, from, to), back = shortest_path(graph, to, from);
  RC_ASSERT(path && back);
  RC_ASSERT(std::abs(path->length_m() - back->length_m()) < 1e-9);
  const std::vector<Vec2> points = path->points(graph);
  RC_ASSERT((points.front() - from.p_map).norm() < 1e-9);
  RC_ASSERT((points.back() - to.p_map).norm() < 1e-9);
  RC_ASSERT(std::abs(polyline_length_m(points) - path->length_m()) < 1e-9);
}

/// How often each corridor is driven; the path must be connected and end where it began.
std::vector<int> times_driven(const CorridorGraph& graph, const CorridorPath& path, std::size_t start) {
  std::vector<int> times(graph.corridors.size());
  std::size_t node = start;
  for (const CorridorLeg& leg : path.legs) {
    const Corridor& corridor = graph.corridors[leg.corridor];
    const bool forwards = leg.from_m < leg.to_m;
    RC_ASSERT((forwards ? corridor.from : corridor.to) == node);
    RC_ASSERT(std::abs(leg.length_m() - corridor.length_m()) < 1e-9);
    node = forwards ? corridor.to : corridor.from;
    ++times[leg.corridor];
  }
  RC_ASSERT(node == start);
  return times;
}

/// The least distance that must be driven twice, by trying all pairings of the nodes of odd degree.
double least_pairing(const std::vector<std::vector<double>>& distances, std::vector<std::size_t> odd) {
  if (odd.empty()) return 0;
  const std::size_t first = odd.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < odd.size(); ++i) {
    std::vector<std::size_t> rest = odd;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    rest.erase(rest.begin());
    least = std::min(least, distances[first][odd[i]] + least_pairing(distances, rest));
  }
  return least;
}

RC_GTEST_PROP(Patrol, EveryCorridorIsDrivenOnceOrTwiceAndThePathEndsWhereItBegan, (std::uint64_t seed)) {
  Random random(seed);
  const CorridorGraph graph = any_graph(random, 1 + random.index(40), 1 + random.index(20));
  const std::size_t start = random.index(graph.nodes.size());
  const CorridorPath path = patrol_path(graph, start);
  for (const int times : times_driven(graph, path, start)) RC_ASSERT(times == 1 || times == 2);
  RC_ASSERT(path.length_m() <= 2 * graph.length_m() + 1e-9);
}

RC_GTEST_PROP(Patrol, WithFewOddNodesNoPathIsShorter, (std::uint64_t seed)) {
  Random random(seed);
  const CorridorGraph graph = any_graph(random, 1 + random.index(9), 1 + random.index(5));
  std::vector<std::size_t> odd;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (graph.degree(i) % 2 != 0) odd.push_back(i);
  }
  RC_PRE(odd.size() <= 8U);
  const double least_m = graph.length_m() + least_pairing(all_distances(graph), odd);
  RC_ASSERT(std::abs(patrol_path(graph, 0).length_m() - least_m) < 1e-6);
}

TEST(Patrol, ALoopIsDrivenOnce) {
  EXPECT_DOUBLE_EQ(patrol_path(square_graph(), 2).length_m(), 40);
}

TEST(Patrol, WhatCannotBeReachedIsLeftOut) {
  CorridorGraph graph = square_graph();
  graph.nodes.push_back({CorridorNode::Kind::kEnd, {50, 0}});
  graph.nodes.push_back({CorridorNode::Kind::kEnd, {60, 0}});
  graph.corridors.push_back({4, 5, {{50, 0}, {60, 0}}, 2});
  EXPECT_DOUBLE_EQ(patrol_path(graph, 0).length_m(), 40);
  EXPECT_DOUBLE_EQ(patrol_path(graph, 5).length_m(), 20);
}

}  // namespace
}  // namespace aisle
