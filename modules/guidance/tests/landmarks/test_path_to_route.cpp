#include "aisle/guidance/landmarks/path_to_route.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kCycleOfCart_s = 0.1;
constexpr double kSamePlace_m = 0.25;

/// A corridor 2.4 m wide, seen from inside, along the floor's x axis. The route leads along its middle from
/// end to end. Map and floor have different frames.
class PathToRouteTest : public testing::Test {
 protected:
  Pose2 in_map(const Pose2& T_floor) const { return T_map_floor_ * T_floor; }

  Path route() const { return Path({{in_map({0, 1.2, 0}), {7, 0}}}); }

  /// Drives a cart that executes commands without delay, for at most three minutes.
  PathToRoute::State bring(const KnownFloor& known, const Pose2& T_floor_vehicle) {
    PathToRoute path(cart(), {}, {.speed_mps = 0.2}, known);
    T_map_vehicle_ = in_map(T_floor_vehicle);
    path.begin(route(), T_map_floor_, T_map_vehicle_);
    PathToRoute::State state = PathToRoute::State::kSearching;
    double steering_rad = 0;
    for (int i = 0;
         i < 1800 && (state == PathToRoute::State::kSearching || state == PathToRoute::State::kDriving);
         ++i) {
      Command command;
      state = path.step(T_map_vehicle_, steering_rad, command);
      steering_rad = command.steering_rad;
      T_map_vehicle_ =
          T_map_vehicle_ *
          drive(cart().front_steered, FrontSteeredMotion{kCycleOfCart_s * command.speed_mps, steering_rad});
    }
    return state;
  }

  void expect_on_route() const {
    const Pose2 T_floor_vehicle = between(T_map_floor_, T_map_vehicle_);
    EXPECT_NEAR(T_floor_vehicle.y, 1.2, kSamePlace_m);
    EXPECT_NEAR(T_floor_vehicle.theta, 0, 15 * kDegree);
  }

  const Pose2 T_map_floor_{3, -2, 70 * kDegree};
  const KnownFloor corridor_ = free_floor({{Vec2(0, 0), Vec2(7, 2.4)}});
  Pose2 T_map_vehicle_;
};

TEST_F(PathToRouteTest, TurnsAVehicleThatFacesTheWrongWay) {
  EXPECT_EQ(bring(corridor_, {3.5, 1.2, kPi}), PathToRoute::State::kThere);
  expect_on_route();
}

TEST_F(PathToRouteTest, BringsAVehicleBackFromASideCorridor) {
  const KnownFloor crossing = free_floor({{Vec2(0, 0), Vec2(7, 2.4)}, {Vec2(2.5, -4), Vec2(4.5, 0)}});
  EXPECT_EQ(bring(crossing, {3.5, -2, 90 * kDegree}), PathToRoute::State::kThere);
  expect_on_route();
}

TEST_F(PathToRouteTest, TellsWhereItLeadsWhileItDrives) {
  const KnownFloor crossing = free_floor({{Vec2(0, 0), Vec2(7, 2.4)}, {Vec2(2.5, -4), Vec2(4.5, 0)}});
  PathToRoute path(cart(), {}, {.speed_mps = 0.2}, crossing);
  const Pose2 T_map_vehicle = in_map({3.5, -2, 90 * kDegree});
  path.begin(route(), T_map_floor_, T_map_vehicle);
  EXPECT_TRUE(path.ahead(T_map_vehicle, 2).empty());
  PathToRoute::State state = PathToRoute::State::kSearching;
  Command command;
  while (state == PathToRoute::State::kSearching) state = path.step(T_map_vehicle, 0, command);
  ASSERT_EQ(state, PathToRoute::State::kDriving);
  const PathAhead ahead = path.ahead(T_map_vehicle, 2);
  ASSERT_FALSE(ahead.empty());
  EXPECT_LT(ahead.front().T_there_vehicle.position().norm(), 1e-6);
  const Footprint footprint = cart().footprint;
  const Vec2 before_it{footprint.front_m + 0.3, 0}, behind_it{-footprint.rear_m - 0.3, 0};
  EXPECT_TRUE(path_to(before_it, ahead, footprint, 0.02));
  EXPECT_FALSE(path_to(behind_it, ahead, footprint, 0.02));
}

TEST_F(PathToRouteTest, AVehicleOnItsRouteIsThereAtOnce) {
  EXPECT_EQ(bring(corridor_, {5, 1.25, 2 * kDegree}), PathToRoute::State::kThere);
  EXPECT_LT((T_map_vehicle_.position() - in_map({5, 1.25, 0}).position()).norm(), 1e-9);
}

TEST_F(PathToRouteTest, WhereNoKnownFloorLeadsToTheRouteThereIsNoPath) {
  const KnownFloor room = free_floor({{Vec2(0, -6), Vec2(2, -5)}});
  EXPECT_EQ(bring(room, {0.6, -5.5, 0}), PathToRoute::State::kNoPath);
}

TEST_F(PathToRouteTest, DoesNotSearchForARouteFarAway) {
  const KnownFloor room = free_floor({{Vec2(0, -36), Vec2(3, -32)}});
  EXPECT_EQ(bring(room, {1, -34, 0}), PathToRoute::State::kNoPath);
}

}  // namespace
}  // namespace aisle
