#include "aisle/guidance/room_navigator.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <vector>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/guidance/room_cameras.hpp"

namespace aisle {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr double kRoomCycle_s = 0.1, kFloorGrey = 165, kWallGrey = 60, kWayLength_m = 2.5;

VehicleDescription room_cart() {
  VehicleDescription vehicle;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6};
  CameraDescription camera;
  camera.name = kFirstCamera;
  camera.width_px = 256;
  camera.height_px = 243;
  camera.intrinsics = {.fx_px = 215, .fy_px = 215, .cx_px = 127.5, .cy_px = 121};
  camera.mount = {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree};
  vehicle.cameras = {camera};
  return vehicle;
}

Route straight_route() {
  RoomRoute room;
  room.brightness.grey = kFloorGrey;
  return {.name = "straight",
          .path = Path(std::vector{PathPiece{{}, {kWayLength_m, 0}}}),
          .start_view = {},
          .sections = {},
          .room = room};
}

/// A bright floor, and a dark wall across the way.
class DrivenRoom {
 public:
  explicit DrivenRoom(double wall_m) : wall_m_(wall_m), navigator_({}, vehicle_, straight_route()) {
    const CameraDescription& camera = vehicle_.cameras.front();
    const BackProjection floor(CameraModel(camera.intrinsics), camera.mount, 0);
    for (int v = 0; v < camera.height_px; ++v) {
      for (int u = 0; u < camera.width_px; ++u) {
        const auto p = floor.point(Vec2(u, v));
        p_vehicle_.push_back(p ? *p : Vec2(1e6, 0));
      }
    }
  }

  Decision step(double light = 1) {
    Observation observation;
    observation.stamp_s = ++cycles_ * kRoomCycle_s;
    const double way_m = kRoomCycle_s * decision_.command.speed_mps;
    const FrontSteeredMotion motion{way_m, decision_.command.steering_rad};
    T_world_vehicle_ = T_world_vehicle_ * drive(vehicle_.front_steered, motion);
    observation.odometry = motion;
    observation.pictures = {{kFirstCamera, observation.stamp_s, picture(light)}};
    return decision_ = navigator_.step(observation);
  }

  const Pose2& T_world_vehicle() const { return T_world_vehicle_; }
  const RoomNavigator& navigator() const { return navigator_; }

 private:
  /// No two are quite the same, or the camera would be taken for frozen.
  std::shared_ptr<const Image> picture(double light) const {
    const CameraDescription& camera = vehicle_.cameras.front();
    auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
    for (std::size_t i = 0; i < p_vehicle_.size(); ++i) {
      const bool is_wall = (T_world_vehicle_ * p_vehicle_[i]).x() > wall_m_;
      image->bytes[i] = static_cast<std::uint8_t>(light * (is_wall ? kWallGrey : kFloorGrey));
    }
    image->bytes.front() = static_cast<std::uint8_t>(cycles_ % 2);
    return image;
  }

  double wall_m_;
  VehicleDescription vehicle_ = room_cart();
  RoomNavigator navigator_;
  std::vector<Vec2> p_vehicle_;  ///< that each pixel sees
  Pose2 T_world_vehicle_;
  Decision decision_;
  int cycles_ = 0;
};

TEST(RoomNavigator, GoesOnByMemoryWhereWhatItHasSeenHidesTheRoute) {
  DrivenRoom room(kWayLength_m + 1.3);
  Decision decision;
  for (int i = 0; i < 200 && decision.status == NavigatorStatus::kGoing; ++i) {
    decision = room.step();
    EXPECT_THAT(decision.state, AnyOf("following", "avoiding", "parked")) << room.T_world_vehicle().x;
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
  EXPECT_NEAR(room.T_world_vehicle().x, kWayLength_m, 0.05);
}

TEST(RoomNavigator, WaitsWhereTheLightChangesAndNothingIsKnownToStand) {
  DrivenRoom room(20);
  for (int i = 0; i < 20; ++i) EXPECT_GT(room.step().command.speed_mps, 0);
  const Decision decision = room.step(0.5);
  EXPECT_EQ(decision.state, "waiting");
  EXPECT_EQ(decision.command.speed_mps, 0);
}

TEST(RoomNavigator, SaysThatNothingHasConfirmedItsPlace) {
  DrivenRoom room(20);
  Decision decision;
  for (int i = 0; i < 200 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step();
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
  EXPECT_THAT(decision.why, HasSubstr("not confirmed"));
  EXPECT_FALSE(room.navigator().has_confirmed_place());
}

}  // namespace
}  // namespace aisle
