#include "aisle/guidance/rooms/room_navigator.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"

namespace aisle {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr double kRoomCycle_s = 0.1, kFloorGrey = 165, kWallGrey = 60, kPathLength_m = 2.5;

VehicleDescription room_cart() {
  VehicleDescription vehicle;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6};
  CameraDescription camera;
  camera.name = kFirstCamera;
  camera.width_px = 128;
  camera.height_px = 122;
  camera.intrinsics = {.fx_px = 107.5, .fy_px = 107.5, .cx_px = 63.5, .cy_px = 60.5};
  camera.mount = {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree};
  vehicle.cameras = {camera};
  return vehicle;
}

VehicleDescription room_cart_with_third_camera() {
  VehicleDescription vehicle = room_cart();
  CameraDescription camera = vehicle.cameras.front();
  camera.name = kThirdCamera;
  camera.intrinsics.fx_px = camera.intrinsics.fy_px = 87.5;
  camera.mount = {.p_vehicle_camera = {0.92, 0, 0.45}, .tilt_rad = 32 * kDegree};
  vehicle.cameras.push_back(camera);
  return vehicle;
}

Route straight_route() {
  RoomRoute room;
  room.brightness.grey = kFloorGrey;
  return {.name = "straight",
          .path = Path(std::vector{PathPiece{{}, {kPathLength_m, 0}}}),
          .start_view = {},
          .sections = {},
          .room = room};
}

constexpr double kLegIn_m = 6, kLegBack_m = 2.4;

/// A route straight in, straight back, and in again to where a turning to the right begins.
/// @param side_m  lateral distance of the edges seen on both sides; 0: none were seen
Route route_with_path_back(double side_m) {
  Route route = straight_route();
  const Pose2 T_map_in{kLegIn_m, 0, 0}, T_map_back{kLegIn_m - kLegBack_m, 0, 0};
  route.path = Path({{{}, {kLegIn_m, 0}}, {T_map_in, {-kLegBack_m, 0}}, {T_map_back, {kPathLength_m, 0}}});
  constexpr int kRight = 5;
  const double begin_m = kLegIn_m + kLegBack_m;
  route.room->turnings = {{.number = kRight, .start_m = begin_m, .end_m = begin_m + 1}};
  constexpr double kSeenFrom_m = 3;
  for (double x = kSeenFrom_m; side_m > 0 && x < kLegIn_m + kSeenFrom_m; x += 0.05)
    for (const double side : {-1.0, 1.0})
      route.room->edges.push_back({x - kSeenFrom_m, Vec2(x, side * side_m)});
  return route;
}

/// A bright floor, a dark wall across the path, and walls beside it.
class DrivenRoom {
 public:
  explicit DrivenRoom(double wall_m, Route route = straight_route(), double from_m = 0, double side_m = 50,
                      FloorRules rules = {})
      : wall_m_(wall_m),
        side_m_(side_m),
        vehicle_(backs_between_turnings(route) ? room_cart_with_third_camera() : room_cart()),
        navigator_({}, vehicle_, std::move(route), from_m, std::move(rules)),
        T_world_vehicle_(navigator_.pose()) {
    for (const CameraDescription& camera : vehicle_.cameras) {
      const BackProjection floor(CameraModel(camera.intrinsics), camera.mount, 0);
      auto& p_vehicle = p_vehicle_.emplace_back();
      for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
          const auto p = floor.point(Vec2(u, v));
          p_vehicle.push_back(p ? *p : Vec2(1e6, 0));
        }
      }
    }
  }

  Decision step(double light = 1) {
    Observation observation;
    observation.stamp_s = ++cycles_ * kRoomCycle_s;
    const double path_m = kRoomCycle_s * decision_.command.speed_mps;
    const FrontSteeredMotion motion{path_m, decision_.command.steering_rad};
    T_world_vehicle_ = T_world_vehicle_ * drive(vehicle_.front_steered, motion);
    observation.odometry = motion;
    for (std::size_t i = 0; i < vehicle_.cameras.size(); ++i)
      observation.images.push_back({vehicle_.cameras[i].name, observation.stamp_s, image(i, light)});
    return decision_ = navigator_.step(observation);
  }

  const Pose2& T_world_vehicle() const { return T_world_vehicle_; }
  const RoomNavigator& navigator() const { return navigator_; }

 private:
  /// No two images are the same, as the camera would otherwise count as frozen.
  std::shared_ptr<const Image> image(std::size_t number, double light) const {
    const CameraDescription& camera = vehicle_.cameras[number];
    auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
    for (std::size_t i = 0; i < p_vehicle_[number].size(); ++i) {
      const Vec2 p_world = T_world_vehicle_ * p_vehicle_[number][i];
      const bool is_wall = p_world.x() > wall_m_ || std::abs(p_world.y()) > side_m_;
      image->bytes[i] = static_cast<std::uint8_t>(light * (is_wall ? kWallGrey : kFloorGrey));
    }
    image->bytes.front() = static_cast<std::uint8_t>(cycles_ % 2);
    return image;
  }

  double wall_m_, side_m_;
  VehicleDescription vehicle_;
  RoomNavigator navigator_;
  std::vector<std::vector<Vec2>> p_vehicle_;  ///< that each pixel of each camera sees
  Pose2 T_world_vehicle_;
  Decision decision_;
  int cycles_ = 0;
};

TEST(RoomNavigator, DrivesFromMemoryWhereAKnownObstacleHidesTheRoute) {
  DrivenRoom room(kPathLength_m + 1.3);
  Decision decision;
  for (int i = 0; i < 200 && decision.status == NavigatorStatus::kGoing; ++i) {
    decision = room.step();
    EXPECT_THAT(decision.state, AnyOf("following", "avoiding", "parked")) << room.T_world_vehicle().x;
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
  EXPECT_NEAR(room.T_world_vehicle().x, kPathLength_m, 0.05);
}

TEST(RoomNavigator, WaitsIfTheLightChangesWithoutAKnownObstacle) {
  DrivenRoom room(20);
  for (int i = 0; i < 20; ++i) EXPECT_GT(room.step().command.speed_mps, 0);
  Decision decision = room.step(0.5);
  EXPECT_EQ(decision.state, "waiting");
  EXPECT_EQ(decision.why, "the floor ahead is 0.5 times as bright as it was taught");
  EXPECT_EQ(decision.command.speed_mps, 0);
  for (int i = 0; i < 1000 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step(0.5);
  EXPECT_EQ(decision.state, "blocked");
  EXPECT_THAT(decision.why, HasSubstr("bright"));
}

TEST(RoomNavigator, SaysThatNothingHasConfirmedItsPlace) {
  DrivenRoom room(20);
  Decision decision;
  for (int i = 0; i < 200 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step();
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
  EXPECT_THAT(decision.why, HasSubstr("not confirmed"));
  EXPECT_FALSE(room.navigator().has_confirmed_place());
}

TEST(RoomNavigator, DoesNotReverseOverUnknownFloor) {
  constexpr double kWall_m = 1.6, kSide_m = 0.6;
  DrivenRoom room(kWall_m, straight_route(), 0, kSide_m);
  Decision decision;
  bool has_backed_off = false;
  for (int i = 0; i < 1000 && decision.status == NavigatorStatus::kGoing; ++i) {
    decision = room.step();
    has_backed_off = has_backed_off || decision.state == "backing off";
    EXPECT_GT(room.T_world_vehicle().x, -0.02) << "it started there";
  }
  EXPECT_TRUE(has_backed_off);
  EXPECT_EQ(decision.state, "blocked");
  EXPECT_EQ(decision.why, "found no path past the obstacle");
}

TEST(RoomNavigator, SaysThatItCannotTellAFloorPatternFromObstacles) {
  Route route = straight_route();
  for (double x = 0.5; x < kPathLength_m; x += 0.4) route.room->edges.push_back({0, Vec2(x, 0.1)});
  DrivenRoom room(1.6, std::move(route), 0, 0.6);
  Decision decision;
  for (int i = 0; i < 1000 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step();
  EXPECT_EQ(decision.state, "blocked");
  EXPECT_THAT(decision.why, HasSubstr("pattern"));
}

TEST(RoomNavigator, DoesNotLookForADeadEndFarBeyondTheTaughtOne) {
  Route route = straight_route();
  route.room->parking = ParkingStrategy::kDeadEnd;
  DrivenRoom room(20, std::move(route));
  Decision decision;
  for (int i = 0; i < 400 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step();
  EXPECT_EQ(decision.state, "no dead end");
  EXPECT_LT(room.T_world_vehicle().x, kPathLength_m + 0.3);
}

/// How far the rear corners get to the side, and the vehicle back, while it reverses between turnings.
struct PathBack {
  double lateral_m = 0;
  double back_m = 0;
};

PathBack path_back_between_turnings(double side_m) {
  DrivenRoom room(20, route_with_path_back(side_m), kLegIn_m);
  PathBack driven;
  for (int i = 0; i < 400; ++i) {
    if (room.step().state != "backing" && driven.back_m > 0) return driven;
    for (const double y : {-0.3, 0.3})
      driven.lateral_m = std::max(driven.lateral_m, std::abs((room.T_world_vehicle() * Vec2(-0.25, y)).y()));
    driven.back_m = kLegIn_m - room.T_world_vehicle().x;
  }
  return {};
}

TEST(RoomNavigator, ReversesBetweenTurningsOnKnownFloorOnly) {
  const PathBack narrow = path_back_between_turnings(0);
  EXPECT_GT(narrow.back_m, 1);
  EXPECT_LT(narrow.lateral_m, 0.7) << "the floor was in view up to there at teaching";
  const PathBack wide = path_back_between_turnings(1.5);
  EXPECT_GT(wide.back_m, kLegBack_m);
  EXPECT_GT(wide.lateral_m, 1);
}

FloorRules rules_of(Zone zone) {
  zone.outline = {{2, -2}, {2.4, -2}, {2.4, 2}, {2, 2}};
  Building building;
  building.zones = {std::move(zone)};
  return {building, room_cart()};
}

TEST(RoomNavigator, StopsBeforeAKeepOutZone) {
  DrivenRoom room(20, straight_route(), 0, 50, rules_of({.kind = Zone::Kind::kKeepOut}));
  Decision decision;
  for (int i = 0; i < 200 && decision.status == NavigatorStatus::kGoing; ++i) decision = room.step();
  EXPECT_EQ(decision.status, NavigatorStatus::kFailed);
  EXPECT_EQ(decision.why, "keep-out line ahead");
  EXPECT_LT(room.T_world_vehicle().x + room_cart().footprint.front_m, 2);
}

TEST(RoomNavigator, IsSlowInASlowZone) {
  DrivenRoom room(20, straight_route(), 0, 50, rules_of({.kind = Zone::Kind::kSlow, .speed_max_mps = 0.05}));
  Decision decision;
  for (int i = 0; i < 600 && decision.status == NavigatorStatus::kGoing; ++i) {
    decision = room.step();
    const double x_m = room.T_world_vehicle().x;
    if (x_m > 1.2 && x_m < 2.4) {
      EXPECT_LE(decision.command.speed_mps, 0.05 + 1e-9) << x_m;
    }
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
}

}  // namespace
}  // namespace aisle
