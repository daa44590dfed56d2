#include <gmock/gmock.h>

#include "aisle/simulation/moving_bodies.hpp"
#include "plain_vehicles.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Pose2 kFarAway{100, 100, 0};

Person passer_by() {
  return {.path = {{0, 0}, {2, 0}, {2, 1}}, .speed_mps = 0.5, .start_s = 1};
}

Pose2 pose_at(double time_s, const Pose2& T_world_vehicle = kFarAway) {
  Walker walker(passer_by());
  Pose2 T_world_person;
  for (int i = 1; i <= std::lround(time_s * 100); ++i) {
    T_world_person = walker.step(0.01 * i, 0.01, kCart, T_world_vehicle)->T_world_body;
  }
  return T_world_person;
}

TEST(Walker, WalksThereAndBack) {
  EXPECT_THAT(pose_at(0.9), PoseNear(Pose2{0, 0, 0}, 1e-9, 1e-9));
  EXPECT_THAT(pose_at(3), PoseNear(Pose2{1, 0, 0}, 0.01, 1e-9));
  EXPECT_THAT(pose_at(6), PoseNear(Pose2{2, 0.5, kPi / 2}, 0.01, 1e-9));
  EXPECT_THAT(pose_at(8), PoseNear(Pose2{2, 0.5, -kPi / 2}, 0.01, 1e-9));
  EXPECT_THAT(pose_at(11), PoseNear(Pose2{1, 0, -kPi}, 0.01, 1e-9));
  EXPECT_THAT(pose_at(15), PoseNear(Pose2{1, 0, 0}, 0.01, 1e-9));
}

TEST(Walker, WaitsBeforeTheVehicleAndThenTurnsBack) {
  const Pose2 T_world_vehicle = {1.5, 0, 0};  // its rear is at x = 1.3
  EXPECT_THAT(pose_at(6, T_world_vehicle), PoseNear(Pose2{1.3 - 0.25 - 0.15, 0, 0}, 0.01, 1e-9));
  EXPECT_THAT(pose_at(7.8, T_world_vehicle), PoseNear(Pose2{0.4, 0, -kPi}, 0.02, 1e-9));
}

TEST(Walker, GoesAwayWhereTheVehicleHasComeNearerThanPeopleKeep) {
  Walker walker(passer_by());
  for (int i = 1; i <= 300; ++i) walker.step(0.01 * i, 0.01, kCart, kFarAway);
  const Pose2 T_world_vehicle = {1.5, 0, 0};  // its rear is 5 cm from who stands at x = 1
  Pose2 T_world_person;
  for (int i = 301; i <= 900; ++i)
    T_world_person = walker.step(0.01 * i, 0.01, kCart, T_world_vehicle)->T_world_body;
  EXPECT_THAT(T_world_person, PoseNear(Pose2{0, 0, -kPi}, 0.05, 1e-9));
}

TEST(MovingBodies, ABoxAppearsOnceThereIsRoomAndGoesAfterItsTime) {
  ScenarioPlay play(
      {.events = {{.fault = BlockingBox{.T_world_box = {3, 0, 0}}, .from_s = 1, .duration_s = 2}}});
  MovingBodies bodies({});
  const auto count_at = [&](double now_s, const Pose2& T_world_vehicle) {
    play.advance(now_s, T_world_vehicle.position());
    bodies.step(now_s, 0.01, play, kCart, T_world_vehicle);
    return bodies.all().size();
  };
  EXPECT_EQ(count_at(0.5, kFarAway), 0U);
  EXPECT_EQ(count_at(1.5, {2.5, 0, 0}), 0U);
  EXPECT_EQ(count_at(1.6, {0, 0, 0}), 1U);
  EXPECT_THAT(bodies.outlines(), SizeIs(4));
  EXPECT_THAT(bodies.outlines(1.5), IsEmpty());
  EXPECT_EQ(count_at(3.6, {0, 0, 0}), 0U);
}

}  // namespace
}  // namespace aisle
