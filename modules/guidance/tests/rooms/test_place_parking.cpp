#include "aisle/guidance/rooms/place_parking.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kCycle_s = 0.1;
const Pose2 kEnd{4, 0, 0};

/// 4 m straight on.
PlaceParking parking(const PlaceParkingParams& params = {}) {
  return {params, cart(), Path(std::vector{PathPiece{{}, {4, 0}}})};
}

Pose2 moved(const Pose2& T_map_vehicle, double speed_mps, double steering_rad) {
  return T_map_vehicle * drive(cart().front_steered, FrontSteeredMotion{kCycle_s * speed_mps, steering_rad});
}

TEST(PlaceParking, IsDoneIfItStandsWell) {
  PlaceParking place = parking();
  EXPECT_EQ(place.settle(kEnd * Pose2{0, 0.04, 1 * kDegree}, false).status, NavigatorStatus::kDone);
  EXPECT_EQ(place.tries(), 1);
}

TEST(PlaceParking, BacksOffIfMisalignedAndThenStandsBetter) {
  PlaceParking place = parking();
  const Path path(std::vector{PathPiece{{}, {4, 0}}});
  Pose2 T_map_vehicle = kEnd * Pose2{0, 0.15, -6 * kDegree};
  EXPECT_EQ(place.settle(T_map_vehicle, false).status, NavigatorStatus::kGoing);
  ASSERT_TRUE(place.is_backing());
  double steering_rad = 0;
  for (int i = 0; i < 300 && place.is_backing(); ++i) {
    const Command command = place.back_off(T_map_vehicle, steering_rad);
    EXPECT_LT(command.speed_mps, 0);
    steering_rad = command.steering_rad;
    T_map_vehicle = moved(T_map_vehicle, command.speed_mps, steering_rad);
    place.judge_path_back(T_map_vehicle, 1.5);
  }
  ASSERT_FALSE(place.is_backing());
  EXPECT_LT(T_map_vehicle.x, 2.6);
  while (T_map_vehicle.x < kEnd.x) {
    const PathPoint point = path.nearest(T_map_vehicle.position(), 0, 4);
    steering_rad = place.steering_rad(point, T_map_vehicle, 0.12, steering_rad);
    T_map_vehicle = moved(T_map_vehicle, 0.12, steering_rad);
  }
  EXPECT_EQ(place.settle(T_map_vehicle, false).status, NavigatorStatus::kDone);
  EXPECT_EQ(place.tries(), 2);
  EXPECT_LT(std::abs(T_map_vehicle.y), 0.03);
}

TEST(PlaceParking, StopsBackingOffBeforeAnObstacleBehind) {
  PlaceParking place = parking();
  place.settle(kEnd * Pose2{0, 0.2, 0}, false);
  place.judge_path_back(kEnd * Pose2{-0.3, 0.2, 0}, 1);
  EXPECT_TRUE(place.is_backing());
  place.judge_path_back(kEnd * Pose2{-0.4, 0.2, 0}, 0.05);
  EXPECT_FALSE(place.is_backing());
}

TEST(PlaceParking, SaysAfterTheLastTryWhetherItHasParked) {
  const auto last = [](const Pose2& off, bool is_taken = false) {
    PlaceParking place = parking({.tries_max = 1});
    return place.settle(kEnd * off, is_taken);
  };
  EXPECT_EQ(last({0, 0.08, 4 * kDegree}).status, NavigatorStatus::kDone);
  const Decision far_off = last({0, 0.2, 0});
  EXPECT_EQ(far_off.status, NavigatorStatus::kFailed);
  EXPECT_EQ(far_off.why, "not parked: it stands 0.20 m to the side, 0.0 degrees turned");
  EXPECT_EQ(last({0, 0, -20 * kDegree}).status, NavigatorStatus::kFailed);
  EXPECT_EQ(last({0, 0.2, 0}, true).status, NavigatorStatus::kDone);
  EXPECT_EQ(last({0, 0.4, 0}, true).status, NavigatorStatus::kFailed);
  EXPECT_EQ(last({0, 0.2, -20 * kDegree}, true).status, NavigatorStatus::kFailed);
}

}  // namespace
}  // namespace aisle
