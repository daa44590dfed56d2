#include "aisle/guidance/landmarks/landmark_navigator.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "aisle/core/random.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AnyOf;

constexpr double kWallOff_m = 1.1, kCorridorEnd_m = 20, kRoute_m = 5, kDoorCycle_s = 0.1;

constexpr double kDark = 50, kBright = 250;  ///< doors

/// A door or notice board from the skirting board up to 2 m.
struct DrawnDoor {
  double from_m = 0, to_m = 0;
  double brightness = 0;
};

/// Along x, with doors on its left (0) and right (1) wall.
struct DoorCorridor {
  std::vector<DrawnDoor> doors[2];

  static constexpr double kWall = 180, kEnd = 150, kFloor = 120, kSkirting = 60, kSkirting_m = 0.1;

  double brightness_of_wall(std::size_t wall, double along_m, double height_m) const {
    if (height_m < kSkirting_m) return kSkirting;
    for (const DrawnDoor& door : doors[wall])
      if (along_m >= door.from_m && along_m <= door.to_m && height_m < 2) return door.brightness;
    return kWall;
  }

  double seen(const Vec3& eye, const Vec3& ray) const {
    const auto reach = [](double off, double speed) {
      return off / speed > 0 ? off / speed : std::numeric_limits<double>::infinity();
    };
    const std::size_t wall = ray.y() > 0 ? 0 : 1;
    const double floor = reach(-eye.z(), ray.z()), end = reach(kCorridorEnd_m - eye.x(), ray.x()),
                 side = reach((wall == 0 ? kWallOff_m : -kWallOff_m) - eye.y(), ray.y());
    if (floor < std::min(end, side)) return kFloor;
    if (end < side) return eye.z() + end * ray.z() < kSkirting_m ? kSkirting : kEnd;
    return brightness_of_wall(wall, eye.x() + side * ray.x(), eye.z() + side * ray.z());
  }

  /// The doors' edges, up to a place.
  LandmarkMap landmarks(double to_m = kCorridorEnd_m) const {
    LandmarkMap map;
    for (const std::size_t wall : {0U, 1U}) {
      for (const DrawnDoor& door : doors[wall]) {
        for (const double x : {door.from_m, door.to_m}) {
          if (x > to_m) continue;
          Landmark landmark;
          landmark.p_map = {x, wall == 0 ? kWallOff_m : -kWallOff_m};
          landmark.covariance = 1e-4 * Mat2::Identity();
          landmark.mass = 1;
          landmark.sightings = 10;
          landmark.passes = 1;
          landmark.seen_from = Vec2(-3, -landmark.p_map.y()).normalized();
          // on the left wall, what is farther away is on the right
          const bool is_darker_beyond = x == door.from_m ? door.brightness < kWall : door.brightness > kWall;
          landmark.brighter_right = (wall == 0) != is_darker_beyond;
          map.add(landmark);
        }
      }
    }
    return map;
  }
};

/// No two parts of it look alike.
DoorCorridor uneven_corridor() {
  DoorCorridor corridor;
  corridor.doors[0] = {{1.4, 2.3, kDark},   {2.7, 3.1, kBright}, {4.5, 5.9, kDark},     {6.3, 6.6, kDark},
                       {7.0, 8.2, kBright}, {9.6, 10.1, kDark},  {10.9, 11.3, kBright}, {12.9, 14.0, kDark}};
  corridor.doors[1] = {{0.9, 1.2, kBright}, {2.0, 3.5, kBright}, {3.9, 4.3, kDark},     {5.5, 6.1, kBright},
                       {7.6, 8.0, kDark},   {8.5, 9.9, kDark},   {10.4, 10.7, kBright}, {11.9, 12.5, kDark}};
  return corridor;
}

/// The same doors, dark where they were bright: no line of it is known.
DoorCorridor negative_of(DoorCorridor corridor) {
  for (std::vector<DrawnDoor>& doors : corridor.doors)
    for (DrawnDoor& door : doors) door.brightness = door.brightness == kDark ? kBright : kDark;
  return corridor;
}

VehicleDescription door_cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.front_steered_noise = {.distance_scale = 0.02,
                                 .distance_slip_m_per_sqrt_m = 0.005,
                                 .heading_slip_rad_per_sqrt_m = 0.5 * kDegree,
                                 .distance_quantum_m = 0.001,
                                 .steering_bias_rad = 0.5 * kDegree,
                                 .steering_quantum_rad = 0};
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.3};
  CameraDescription& camera = vehicle.cameras.emplace_back();
  camera.name = "corridor";
  camera.width_px = 320;
  camera.height_px = 240;
  camera.intrinsics = {.fx_px = 230, .fy_px = 230, .cx_px = 159.5, .cy_px = 119.5};
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  return vehicle;
}

std::shared_ptr<const Image> corridor_image(const DoorCorridor& corridor, const Pose2& T_map_vehicle,
                                            Random& random) {
  const VehicleDescription vehicle = door_cart();
  const CameraDescription& camera = vehicle.cameras[0];
  const Mat3 R_vehicle_camera = camera.mount.R_vehicle_camera();
  Mat3 R_map_camera = R_vehicle_camera;
  R_map_camera.topRows<2>() = rotation(T_map_vehicle.theta) * R_vehicle_camera.topRows<2>();
  const Vec2 p_map_camera = T_map_vehicle * camera.mount.p_vehicle_camera.head<2>().eval();
  const Vec3 eye{p_map_camera.x(), p_map_camera.y(), camera.mount.p_vehicle_camera.z()};
  auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
  for (int v = 0; v < image->height_px; ++v) {
    for (int u = 0; u < image->width_px; ++u) {
      double sum = 0;
      for (const double du : {-0.33, 0.0, 0.33}) {
        const Vec3 ray{(u + du - camera.intrinsics.cx_px) / camera.intrinsics.fx_px,
                       (v + du / 2 - camera.intrinsics.cy_px) / camera.intrinsics.fy_px, 1};
        sum += corridor.seen(eye, R_map_camera * ray);
      }
      // a little noise: no image is like the one before
      image->row(v)[u] = static_cast<std::uint8_t>(sum / 3 + static_cast<double>(random.bits() % 4));
    }
  }
  return image;
}

Path door_route() {
  return Path({PathPiece{{0, 0, 0}, {kRoute_m, 0}}});
}

Building door_building(const DoorCorridor& corridor, double known_to_m = kCorridorEnd_m) {
  Building building;
  building.name = "doors";
  building.camera = door_cart().cameras[0];
  building.landmarks = corridor.landmarks(known_to_m);
  building.routes.push_back({.name = "along", .path = door_route(), .start_view = {}});
  return building;
}

/// A vehicle that obeys at once, and whose odometry is a little wrong.
struct DoorDrive {
  DoorCorridor corridor = uneven_corridor();
  Building building = door_building(corridor);
  LandmarkNavigatorParams params;
  Pose2 T_map_vehicle{0.04, 0.05, 1 * kDegree};
  /// Changes what the vehicle is about to see.
  std::function<void(Observation&)> tamper;

  Decision last;
  double stamp_s = 0;
  std::vector<Observation> observations;
  std::vector<Decision> decisions;
  std::unique_ptr<LandmarkNavigator> navigator;

  /// Until it is done or has given up, or `until` holds.
  void go(double time_max_s, const std::function<bool()>& until = nullptr) {
    if (!navigator)
      navigator = std::make_unique<LandmarkNavigator>(params, door_cart(), building, building.routes[0].path);
    for (const double end_s = stamp_s + time_max_s; stamp_s < end_s;) {
      step();
      if (last.status != NavigatorStatus::kGoing || (until && until())) return;
    }
  }

  void step() {
    const FrontSteeredMotion driven{last.command.speed_mps * kDoorCycle_s, last.command.steering_rad};
    T_map_vehicle = T_map_vehicle * drive(door_cart().front_steered, driven);
    stamp_s += kDoorCycle_s;
    Observation observation{
        .stamp_s = stamp_s,
        .odometry = FrontSteeredMotion{1.02 * driven.distance_m, driven.steering_rad + 0.3 * kDegree}};
    observation.images.push_back({"corridor", stamp_s, corridor_image(corridor, T_map_vehicle, random_)});
    if (tamper) tamper(observation);
    last = navigator->step(observation);
    observations.push_back(std::move(observation));
    decisions.push_back(last);
  }

 private:
  Random random_{7};
};

TEST(LandmarkNavigator, FollowsItsRouteToTheEndAndIsDone) {
  DoorDrive drive;
  drive.go(60);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kDone) << drive.last.state << ": " << drive.last.why;
  EXPECT_EQ(drive.last.command, Command{});
  EXPECT_THAT(drive.T_map_vehicle, PoseNear(Pose2{kRoute_m, 0, 0}, 0.05, 2 * kDegree));
  EXPECT_THAT(drive.navigator->fix().T_map_vehicle.mean, PoseNear(drive.T_map_vehicle, 0.05, 1 * kDegree));
}

TEST(LandmarkNavigator, LooksBeforeItStarts) {
  DoorDrive drive;
  drive.params.look_s = 2;
  drive.go(10, [&] { return drive.last.command.speed_mps > 0; });
  EXPECT_GE(drive.stamp_s, 2);
  EXPECT_LT(drive.stamp_s, 2.5);
  EXPECT_TRUE(drive.navigator->fix().is_sure);
  EXPECT_THAT(drive.navigator->fix().T_map_vehicle.mean, PoseNear(drive.T_map_vehicle, 0.04, 1 * kDegree));
}

TEST(LandmarkNavigator, TheSameObservationsGiveTheSameDecisions) {
  DoorDrive drive;
  drive.go(4);
  LandmarkNavigator again(drive.params, door_cart(), drive.building, door_route());
  for (std::size_t i = 0; i < drive.observations.size(); ++i)
    ASSERT_EQ(again.step(drive.observations[i]), drive.decisions[i]) << i;
}

TEST(LandmarkNavigator, GivesUpWhereTheMapEndsButNotTheLines) {
  constexpr double kKnown_m = 4.5;
  DoorDrive drive;
  drive.building = door_building(drive.corridor, kKnown_m);
  drive.building.routes[0].path = Path({PathPiece{{0, 0, 0}, {10, 0}}});
  drive.params.give_up_s = 3;
  drive.go(10, [&] { return drive.last.state == "following"; });
  EXPECT_EQ(drive.last.state, "following");
  drive.go(90);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kFailed);
  EXPECT_EQ(drive.last.state, "lost");
  EXPECT_EQ(drive.last.why, "sees what the map does not contain");
  EXPECT_EQ(drive.last.command, Command{});
  EXPECT_LT(drive.T_map_vehicle.x, kKnown_m + drive.params.unmatched_max_m);
}

TEST(LandmarkNavigator, StopsInAnotherCorridorAndSaysWhy) {
  DoorDrive drive;
  drive.params.give_up_s = 3;
  drive.go(30, [&] { return drive.T_map_vehicle.x > 1.5; });
  ASSERT_EQ(drive.last.state, "following");
  const Vec2 p_map_before = drive.T_map_vehicle.position();
  drive.corridor = negative_of(drive.corridor);
  drive.go(60);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kFailed);
  EXPECT_EQ(drive.last.state, "lost");
  EXPECT_THAT(drive.last.why, AnyOf("sees what the map does not contain", "the view has changed suddenly"));
  EXPECT_TRUE(drive.navigator->fix().is_lost);
  EXPECT_LT((drive.T_map_vehicle.position() - p_map_before).norm(), 1);
}

TEST(LandmarkNavigator, CarriedAlongItsRouteItFindsItsPlaceAndArrives) {
  DoorDrive drive;
  drive.go(30, [&] { return drive.T_map_vehicle.x > 1; });
  ASSERT_EQ(drive.last.state, "following");
  drive.T_map_vehicle.x += 1.6;
  bool was_found = false;
  drive.go(60, [&] {
    was_found |= drive.last.state == "found";
    return false;
  });
  EXPECT_TRUE(was_found);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kDone) << drive.last.state << ": " << drive.last.why;
  EXPECT_THAT(drive.T_map_vehicle, PoseNear(Pose2{kRoute_m, 0, 0}, 0.05, 2 * kDegree));
}

/// Drives on while the camera fails in this way, and once it works again.
/// @param fault  of what it is about to see, given what it saw last
void expect_stop_and_recovery(const std::function<void(Observation&, const Observation&)>& fault,
                              const char* why) {
  DoorDrive drive;
  drive.go(30, [&] { return drive.T_map_vehicle.x > 1; });
  ASSERT_EQ(drive.last.state, "following");
  const double failed_s = drive.stamp_s;
  drive.tamper = [&, before = drive.observations.back()](Observation& observation) {
    fault(observation, before);
  };
  drive.go(30, [&] { return drive.last.command.speed_mps == 0; });
  EXPECT_LT(drive.stamp_s - failed_s, drive.params.guard.images.age_max_s + 1.5 * kDoorCycle_s);
  EXPECT_EQ(drive.last.state, "waiting");
  EXPECT_EQ(drive.last.why, why);
  drive.go(2);
  EXPECT_EQ(drive.last.command.speed_mps, 0);
  drive.tamper = nullptr;
  drive.go(60);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kDone) << drive.last.state << ": " << drive.last.why;
}

TEST(LandmarkNavigator, StopsWithoutImagesAndGoesOnWithThem) {
  expect_stop_and_recovery([](Observation& now, const Observation&) { now.images.clear(); },
                           "camera corridor sends no images");
}

TEST(LandmarkNavigator, StopsWhileImagesAreLate) {
  expect_stop_and_recovery([](Observation& now, const Observation&) { now.images[0].stamp_s -= 1; },
                           "camera corridor is late");
}

TEST(LandmarkNavigator, StopsWhileTheImageIsFrozen) {
  expect_stop_and_recovery(
      [](Observation& now, const Observation& before) { now.images[0].pixels = before.images[0].pixels; },
      "camera corridor is frozen");
}

TEST(LandmarkNavigator, GivesUpIfTheCameraStaysAway) {
  DoorDrive drive;
  drive.params.guard.wait_max_s = 2;
  drive.go(30, [&] { return drive.T_map_vehicle.x > 0.5; });
  drive.tamper = [](Observation& observation) { observation.images.clear(); };
  drive.go(10);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kFailed);
  EXPECT_EQ(drive.last.state, "blocked");
  EXPECT_EQ(drive.last.why, "camera corridor sends no images");
}

TEST(LandmarkNavigator, RefusesToCrossABarrier) {
  constexpr double kBarrier_m = 2;
  for (const auto& [kind, why] :
       {std::pair{Barrier::Kind::kKeepOut, "keep-out line ahead"}, {Barrier::Kind::kGlass, "glass ahead"}}) {
    DoorDrive drive;
    drive.building.barriers.push_back({.kind = kind, .segment = {{kBarrier_m, -1.1}, {kBarrier_m, 1.1}}});
    drive.go(60);
    EXPECT_EQ(drive.last.status, NavigatorStatus::kFailed);
    EXPECT_EQ(drive.last.state, "blocked");
    EXPECT_EQ(drive.last.why, why);
    EXPECT_EQ(drive.last.command, Command{});
    const double front_m = drive.T_map_vehicle.x + door_cart().footprint.front_m;
    EXPECT_LT(front_m, kBarrier_m);
    EXPECT_GT(front_m, kBarrier_m - 0.4);
  }
}

TEST(LandmarkNavigator, IsSlowInASlowZone) {
  DoorDrive drive;
  drive.building.zones = {{.kind = Zone::Kind::kSlow,
                           .outline = {{1.5, -1}, {2.5, -1}, {2.5, 1}, {1.5, 1}},
                           .speed_max_mps = 0.1}};
  drive.go(30, [&] { return drive.T_map_vehicle.x > 1; });
  drive.go(30, [&] {
    EXPECT_LE(drive.last.command.speed_mps, 0.1 + 1e-9) << drive.T_map_vehicle.x;
    return drive.T_map_vehicle.x > 2.4;
  });
  drive.go(60);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kDone) << drive.last.why;
}

TEST(LandmarkNavigator, DoesNotDriveAgainstAOneWayZone) {
  DoorDrive drive;
  drive.building.zones = {{.kind = Zone::Kind::kOneWay,
                           .outline = {{1.5, -1}, {2.5, -1}, {2.5, 1}, {1.5, 1}},
                           .direction_rad = kPi}};
  drive.go(60);
  EXPECT_EQ(drive.last.why, "would drive against the one-way zone");
  EXPECT_LT(drive.T_map_vehicle.x, 1.5);
}

TEST(LandmarkNavigator, ABarrierBesideTheRouteDoesNotMatter) {
  DoorDrive drive;
  drive.building.barriers.push_back({.segment = {{0, 0.8}, {5, 0.8}}});
  drive.go(60);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kDone) << drive.last.why;
}

TEST(LandmarkNavigator, GivesUpWhenItTouchesSomething) {
  DoorDrive drive;
  drive.go(30, [&] { return drive.T_map_vehicle.x > 0.5; });
  drive.tamper = [](Observation& observation) { observation.bumper_pressed = true; };
  drive.go(1);
  EXPECT_EQ(drive.last.status, NavigatorStatus::kFailed);
  EXPECT_EQ(drive.last.why, "the bumper is pressed");
  EXPECT_EQ(drive.last.command, Command{});
}

TEST(LandmarkNavigator, AVehicleWithoutTheLandmarksCameraIsRefused) {
  const Building building = door_building(uneven_corridor());
  VehicleDescription vehicle = door_cart();
  vehicle.cameras[0].name = "other";
  EXPECT_THROW(LandmarkNavigator({}, vehicle, building, door_route()), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
