#include <gtest/gtest.h>

#include "aisle/evaluation/exploration/exploration_evaluation.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr SensorField kAllRound{.T_vehicle_sensor = {}, .reach_m = 8, .width_rad = 2 * kPi, .height_m = 0.3};

/// An L of corridors 2 m wide: along x from (0, 0) to (12, 2), then up to (12, 10).
World l_world() {
  World world;
  const Vec2 corners[] = {{0, 0}, {12, 0}, {12, 10}, {10, 10}, {10, 2}, {0, 2}};
  for (std::size_t i = 0; i < std::size(corners); ++i)
    world.walls.push_back({.floor_edge = {corners[i], corners[(i + 1) % std::size(corners)]}});
  return world;
}

/// Through the middles of the corridors and back.
std::vector<Pose2> whole_path() {
  std::vector<Pose2> path;
  for (double x = 1; x < 11; x += 0.1) path.push_back({x, 1, 0});
  for (double y = 1; y < 9; y += 0.1) path.push_back({11, y, kPi / 2});
  std::vector<Pose2> back(path.rbegin(), path.rend());
  path.insert(path.end(), back.begin(), back.end());
  return path;
}

WallMap walls_of(const World& world, const Pose2& T_map_world) {
  WallMap map;
  for (const Segment2& s : cross_section(world, 0.3)) map.walls.push_back({.segment = T_map_world * s});
  return map;
}

FloorGrid known_floor(const Pose2& T_map_world) {
  FloorGrid floor;
  for (double x = 0.01; x < 12; x += 0.02) {
    for (double y = 0.01; y < 10; y += 0.02) {
      if (y < 2 || x > 10) floor.set(floor.cell_at(T_map_world * Vec2(x, y)), Floor::kFree);
    }
  }
  return floor;
}

struct Learned {
  std::vector<Pose2> T_world_vehicle = whole_path();
  std::vector<Pose2> T_map_vehicle;
  FloorGrid floor;
  WallMap walls;

  explicit Learned(const Pose2& T_map_world)
      : floor(known_floor(T_map_world)), walls(walls_of(l_world(), T_map_world)) {
    for (const Pose2& T : T_world_vehicle) T_map_vehicle.push_back(T_map_world * T);
  }
  ExplorationScore figures(const SensorField& sensor = kAllRound) const {
    return evaluate_exploration(
        l_world(), {}, sensor, {T_world_vehicle, map_in_world(T_map_vehicle, T_world_vehicle), floor, walls});
  }
};

TEST(ExplorationEvaluation, TheTruthAgainstItselfIsWithoutError) {
  const ExplorationScore figures = Learned({}).figures();
  EXPECT_NEAR(figures.coverable_m2, 12 * 2 + 2 * 8, 2.5);
  EXPECT_GE(figures.covered_share, 0.998);
  EXPECT_GE(figures.mapped_share, 0.999);
  EXPECT_EQ(figures.home_error_m, 0);
  EXPECT_NEAR(figures.walls.rmse_m, 0, 1e-9);
  EXPECT_EQ(figures.walls.missed_m, 0);
  EXPECT_EQ(figures.walls.false_m, 0);
  EXPECT_NEAR(figures.walls.true_m, 44, 0.5);
  EXPECT_NEAR(figures.graph_bound_m, 2 * 18, 2.5);
}

TEST(ExplorationEvaluation, WhereTheMapsOriginLiesMakesNoDifference) {
  for (const Pose2& T_map_world : {Pose2{-50, 30, 1}, Pose2{0.333, -7, -3}, Pose2{20, 20.02, kPi / 2}}) {
    const ExplorationScore figures = Learned(T_map_world).figures();
    EXPECT_LT(figures.walls.rmse_m, 1e-6);
    EXPECT_EQ(figures.walls.missed_m, 0);
    EXPECT_EQ(figures.walls.false_m, 0);
    EXPECT_GE(figures.mapped_share, 0.999);
  }
}

TEST(ExplorationEvaluation, HalfThePathSeesHalfTheFloor) {
  Learned learned({});
  std::vector<Pose2> short_path(learned.T_world_vehicle.begin(), learned.T_world_vehicle.begin() + 30);
  learned.T_world_vehicle = short_path;
  learned.T_map_vehicle = short_path;
  const ExplorationScore figures = learned.figures();
  EXPECT_NEAR(figures.covered_share, 24.0 / 40, 0.03);
  EXPECT_GE(figures.mapped_share, 0.999);
  EXPECT_NEAR(figures.home_error_m, 2.9, 1e-9);
}

TEST(ExplorationEvaluation, ASensorThatLooksAheadOnlyDoesNotSeeWhatLiesBehind) {
  const SensorField ahead{.T_vehicle_sensor = {}, .reach_m = 8, .width_rad = 90 * kDegree, .height_m = 0.3};
  const double covered_share = Learned({}).figures(ahead).covered_share;
  EXPECT_LT(covered_share, 0.98);
  EXPECT_GT(covered_share, 0.9);
}

TEST(WallErrors, AWallThatIsNotLearnedIsMissedByItsLength) {
  Learned learned({});
  learned.walls.walls.erase(learned.walls.walls.begin());
  const WallErrors errors = learned.figures().walls;
  EXPECT_NEAR(errors.missed_m, 12, 0.2);
  EXPECT_EQ(errors.false_m, 0);
  EXPECT_NEAR(errors.missed_share(), 12.0 / 44, 0.01);
}

TEST(WallErrors, AWallWhereThereIsNoneIsFalseByItsLength) {
  Learned learned({});
  learned.walls.walls.push_back({.segment = {{3, 1}, {6, 1}}});
  const WallErrors errors = learned.figures().walls;
  EXPECT_NEAR(errors.false_m, 3, 0.1);
  EXPECT_EQ(errors.missed_m, 0);
}

TEST(WallErrors, AWallOffByTwoCentimetresHasThatErrorAndIsNeitherFalseNorMissed) {
  const std::vector<Segment2> standing = {{{0, 0}, {10, 0}}};
  const WallMap learned{{Wall{.segment = {{0, 0.02}, {10, 0.02}}}}};
  const WallErrors errors = wall_errors(learned, {}, standing, [](const Vec2&) { return true; });
  EXPECT_NEAR(errors.rmse_m, 0.02, 1e-9);
  EXPECT_EQ(errors.missed_m, 0);
  EXPECT_EQ(errors.false_m, 0);
}

TEST(WallErrors, AWallAcrossIsNotTheWallThatIsMissed) {
  const std::vector<Segment2> standing = {{{0, 0}, {0.6, 0}}};
  const WallMap learned{{Wall{.segment = {{0.3, -0.1}, {0.3, 0.1}}}}};
  EXPECT_NEAR(wall_errors(learned, {}, standing, [](const Vec2&) { return true; }).missed_share(), 1, 1e-9);
}

TEST(WallErrors, WhatCannotBeSeenAndWhatIsTooShortForAWallIsNotMissed) {
  const std::vector<Segment2> standing = {{{0, 0}, {10, 0}}, {{0, 5}, {0.2, 5}}};
  const WallErrors errors = wall_errors({}, {}, standing, [](const Vec2& p) { return p.x() < 4; });
  EXPECT_NEAR(errors.true_m, 4, 0.06);
  EXPECT_NEAR(errors.missed_m, 4, 0.06);
}

TEST(ExplorationEvaluation, OfAMapThatWasTurnedAndBentOnlyTheBendIsAnError) {
  std::vector<Pose2> world, map;
  for (int i = 0; i < 100; ++i) {
    world.push_back({0.1 * i, 0, 0});
    map.push_back(Pose2{3, 4, 1}.inverse() * Pose2{0.1 * i, 0.01 * (i % 2), 0});
  }
  EXPECT_THAT(map_in_world(map, world), PoseNear(Pose2{3, 4, 1}, 0.02, 0.001));
}

TEST(ExplorationEvaluation, ClosedRoomsAreNoCorridorsAndNotMissed) {
  World world = l_world();
  for (const auto& [a, b] : {std::pair(Vec2(0, 3), Vec2(9, 3)), std::pair(Vec2(9, 3), Vec2(9, 9)),
                             std::pair(Vec2(9, 9), Vec2(0, 9)), std::pair(Vec2(0, 9), Vec2(0, 3))})
    world.walls.push_back({.floor_edge = {a, b}});
  const Learned learned({});
  const ExplorationScore figures =
      evaluate_exploration(world, {}, kAllRound, {learned.T_world_vehicle, {}, learned.floor, learned.walls});
  EXPECT_EQ(figures.walls.missed_m, 0);
  EXPECT_NEAR(figures.graph_bound_m, Learned({}).figures().graph_bound_m, 1e-9);
}

}  // namespace
}  // namespace aisle
