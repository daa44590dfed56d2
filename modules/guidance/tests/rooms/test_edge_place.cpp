#include "aisle/guidance/rooms/edge_place.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

namespace aisle {
namespace {

/// Edges along the sides of an aisle 2 m wide and 6 m long that ends at a wall, with a box on its left side.
std::vector<Vec2> furnished_path() {
  constexpr double kApart_m = 0.05;
  std::vector<Vec2> points;
  for (int i = 0; i < 120; ++i) {
    const double x = i * kApart_m;
    points.emplace_back(x, -1);
    points.emplace_back(x, x > 2 && x < 3 ? 0.5 : 1);
  }
  for (int i = 0; i < 10; ++i) {
    points.emplace_back(2, 0.5 + i * kApart_m);
    points.emplace_back(3, 0.5 + i * kApart_m);
  }
  for (int i = 0; i <= 40; ++i) points.emplace_back(6, -1 + i * kApart_m);
  return points;
}

std::vector<RouteEdge> taught(const std::vector<Vec2>& points) {
  std::vector<RouteEdge> edges;
  for (const Vec2& p : points) edges.push_back({std::max(0.0, p.x() - 1.5), p});
  return edges;
}

/// The edges that a camera with a reach of 4 m sees from a pose.
std::vector<SeenEdge> seen(const std::vector<Vec2>& points, const Pose2& T_map_vehicle) {
  std::vector<SeenEdge> edges;
  for (const Vec2& p_map : points) {
    const Vec2 p = T_map_vehicle.inverse() * p_map;
    if (p.x() > 1 && p.x() < 5 && std::abs(p.y()) < 0.6 * p.x()) edges.push_back({p, p.norm()});
  }
  return edges;
}

double off_m(const EdgePlace& place, const Pose2& T_map_vehicle, const Pose2& T_odom_vehicle) {
  return between(T_map_vehicle, place.T_map_odom() * T_odom_vehicle).position().norm();
}

RC_GTEST_PROP(EdgePlace, FindsTheInitialPose, ()) {
  const auto share = [] { return *rc::gen::inRange(-100, 101) / 100.0; };
  const Pose2 T_map_vehicle{1.5 + 0.5 * share(), 0.4 * share(), 15 * kDegree * share()};
  const Pose2 T_odom_vehicle{1.5, 0, 0};
  const auto points = furnished_path();
  EdgePlace place({}, taught(points));
  place.take(seen(points, T_map_vehicle), T_odom_vehicle, 1.5);
  RC_ASSERT(place.is_sure());
  RC_ASSERT(off_m(place, T_map_vehicle, T_odom_vehicle) < 0.05);
  RC_ASSERT(std::abs((place.T_map_odom() * T_odom_vehicle).theta - T_map_vehicle.theta) < 1.5 * kDegree);
}

TEST(EdgePlace, CorrectsOdometryDrift) {
  const auto points = furnished_path();
  EdgePlace place({}, taught(points));
  Pose2 T_map_vehicle{0.5, 0, 0}, T_odom_vehicle = T_map_vehicle;
  for (int i = 0; i < 60; ++i) {
    T_map_vehicle = T_map_vehicle * Pose2{0.05, 0, 0};
    T_odom_vehicle = T_odom_vehicle * Pose2{0.05, 0, 0.2 * kDegree};
    place.take(seen(points, T_map_vehicle), T_odom_vehicle, T_map_vehicle.x);
  }
  EXPECT_LT(off_m(place, T_map_vehicle, T_odom_vehicle), 0.05);
}

/// Right before a wall across the path, images show that wall only, which does not constrain the vehicle
/// along it.
TEST(EdgePlace, EdgesRememberedBesideConstrainWhatALineAheadDoesNot) {
  const auto points = furnished_path();
  EdgePlace place({}, taught(points));
  Pose2 T_map_vehicle{3, 0, 0}, T_odom_vehicle = T_map_vehicle;
  for (int i = 0; i < 40; ++i) {
    T_map_vehicle = T_map_vehicle * Pose2{0.03, 0, 0};
    T_odom_vehicle = T_odom_vehicle * Pose2{0.03, 0.005, 0};
    std::vector<SeenEdge> edges;
    for (const Vec2& p_map : points) {
      const Vec2 p = T_map_vehicle.inverse() * p_map;
      if (p.norm() < 3) edges.push_back({p, std::max(p.norm(), 1.4)});
    }
    place.take(edges, T_odom_vehicle, T_map_vehicle.x);
  }
  EXPECT_LT(off_m(place, T_map_vehicle, T_odom_vehicle), 0.03);
}

TEST(EdgePlace, AMovedBoxCountsLittle) {
  const auto points = furnished_path();
  auto moved = points;
  for (Vec2& p : moved)
    if (p.x() >= 2 && p.x() <= 3 && p.y() > 0) p += Vec2(0.2, -0.15);
  const Pose2 T_map_vehicle{1.6, 0.1, 0.05};
  EdgePlace place({}, taught(points));
  place.take(seen(moved, T_map_vehicle), {1.5, 0, 0}, 1.5);
  EXPECT_LT(off_m(place, T_map_vehicle, {1.5, 0, 0}), 0.1);
}

/// Many points of one object ahead weigh no more than few points of others behind.
TEST(EdgePlace, AMovedBoxThatFillsTheViewCountsNoMoreThanItsLength) {
  const auto points = furnished_path();
  auto moved = points;
  for (Vec2& p : moved)
    if (p.x() >= 2 && p.x() <= 3 && p.y() > 0) p += Vec2(0.15, -0.15);
  const Pose2 T_map_vehicle{1.2, 0, 0};
  const auto off_after = [&](const EdgePlaceParams& params) {
    EdgePlace place(params, taught(points));
    for (int i = 0; i < 60; ++i) {
      std::vector<SeenEdge> edges = seen(moved, T_map_vehicle);
      const std::size_t all = edges.size();
      for (std::size_t k = 0; k < all; ++k) {
        const Vec2 p_map = T_map_vehicle * edges[k].p_vehicle;
        if (p_map.x() >= 2 && p_map.x() <= 3.2 && p_map.y() > 0) edges.insert(edges.end(), 6, edges[k]);
      }
      place.take(edges, T_map_vehicle, T_map_vehicle.x);
    }
    return off_m(place, T_map_vehicle, T_map_vehicle);
  };
  EXPECT_LT(off_after({}), 0.05);
  EXPECT_GT(off_after({.moved_m = 0.001}), 0.05) << "as if nothing could have been moved";
}

/// The first image misleads, as one that shows little may.
TEST(EdgePlace, AnErrorOfTheFirstImageIsSoonCorrected) {
  const auto points = furnished_path();
  const Pose2 T_map_vehicle{1.5, 0, 0}, T_map_wrong{1.55, 0.12, 2 * kDegree};
  EdgePlace place({}, taught(points));
  place.take(seen(points, T_map_wrong), T_map_vehicle, T_map_vehicle.x);
  ASSERT_GT(off_m(place, T_map_vehicle, T_map_vehicle), 0.08);
  for (int i = 0; i < 6; ++i) place.take(seen(points, T_map_vehicle), T_map_vehicle, T_map_vehicle.x);
  EXPECT_LT(off_m(place, T_map_vehicle, T_map_vehicle), 0.03);
}

TEST(EdgePlace, IgnoresEdgesThatDoNotFitOrAreTooFew) {
  const auto points = furnished_path();
  EdgePlace place({}, taught(points));
  place.take(std::vector<SeenEdge>(5, SeenEdge{Vec2(2, 0), 2}), {}, 0);
  EXPECT_FALSE(place.is_sure());
  std::vector<SeenEdge> elsewhere;
  for (int i = 0; i < 60; ++i) elsewhere.push_back({Vec2(2 + 0.02 * i, 0.7 * std::sin(i)), 2});
  place.take(elsewhere, {}, 0);
  EXPECT_FALSE(place.is_sure());
  EdgePlace untaught({}, {});
  untaught.take(seen(points, {}), {1, 2, 0.5}, 0);
  EXPECT_FALSE(untaught.is_sure());
  EXPECT_EQ(untaught.T_map_odom().x, 0);
}

}  // namespace
}  // namespace aisle
