#include <gmock/gmock.h>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/landmarks/landmark_driver.hpp"
#include "aisle/missions/navigators.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// Front-steered, with one camera that looks along corridors.
VehicleDescription cart() {
  VehicleDescription vehicle;
  CameraDescription& camera = vehicle.cameras.emplace_back();
  camera.name = "corridor";
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  return vehicle;
}

Building learned_building() {
  Building building;
  building.camera = cart().cameras[0];
  building.landmarks.add({.p_map = {4.00049, 1}, .covariance = 0.01 * Mat2::Identity(), .mass = 3});
  building.routes.push_back(
      {.name = "there", .path = Path({PathPiece{{1, 0, 0}, {8, 0}}}), .start_view = {}});
  return building;
}

LandmarkMission mission() {
  return {.building = building_json(learned_building()), .route = "there"};
}

std::string problems(const SessionOrigin& origin, const VehicleDescription& vehicle = cart()) {
  const auto navigator = make_navigator(origin, vehicle);
  return navigator.ok() ? "" : to_string(navigator.problems());
}

TEST(LandmarkDriver, IsAmongTheNavigators) {
  EXPECT_THAT(navigator_names(), Contains("landmarks"));
}

TEST(LandmarkDriver, ItsOriginContainsOnlyTheChangedParameters) {
  LandmarkNavigatorParams params;
  params.look_s = 2.5;
  const SessionOrigin origin = LandmarkDriver::origin(params, mission());
  EXPECT_EQ(origin.navigator, "landmarks");
  EXPECT_THAT(origin.parameters, ElementsAre(Pair("look_s", "2.5")));
  EXPECT_EQ(origin.route, "there");
  EXPECT_FALSE(origin.in_reverse);
}

TEST(LandmarkDriver, KnowsTheBuildingAsItIsWritten) {
  const auto driver = LandmarkDriver::make(LandmarkDriver::origin({}, mission()), cart());
  ASSERT_TRUE(driver.ok()) << to_string(driver.problems());
  EXPECT_EQ((*driver)->building().landmarks[0].p_map.x(), 4);
  EXPECT_EQ((*driver)->navigator().fix().T_map_vehicle.mean.x, 1);
}

TEST(LandmarkDriver, StartsFromTheFarEndInReverse) {
  LandmarkMission back = mission();
  back.in_reverse = true;
  const auto driver = LandmarkDriver::make(LandmarkDriver::origin({}, back), cart());
  ASSERT_TRUE(driver.ok()) << to_string(driver.problems());
  const Pose2 T_map_start = (*driver)->navigator().fix().T_map_vehicle.mean;
  EXPECT_NEAR(T_map_start.x, 9, 1e-6);
  EXPECT_NEAR(std::abs(T_map_start.theta), kPi, 1e-6);
}

TEST(LandmarkDriver, IsMadeAgainFromTheSessionsOrigin) {
  LandmarkNavigatorParams params;
  params.look_s = 0.3;
  const SessionOrigin origin = LandmarkDriver::origin(params, mission());
  const auto read = parse_session_origin(session_origin_json(origin), "session");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_EQ(*read, origin);
  const auto first = make_navigator(origin, cart()), second = make_navigator(*read, cart());
  ASSERT_TRUE(first.ok() && second.ok());
  for (int i = 1; i <= 20; ++i) {
    const Observation observation{.stamp_s = 0.1 * i, .odometry = FrontSteeredMotion{0.02 * (i > 5), 0.001}};
    const Decision a = (*first)->step(observation), b = (*second)->step(observation);
    EXPECT_EQ(a.command, b.command);
    EXPECT_EQ(a.state, b.state);
  }
}

TEST(LandmarkDriver, RefusesWhatItCannotDriveBy) {
  LandmarkMission unknown = mission();
  unknown.route = "elsewhere";
  EXPECT_THAT(problems(LandmarkDriver::origin({}, unknown)),
              HasSubstr("route: 'elsewhere' is unknown; the building has: there"));
  LandmarkMission back = mission();
  Building short_one = learned_building();
  short_one.routes[0].path = Path({PathPiece{{1, 0, 0}, {0.1, 0}}});
  back.building = building_json(short_one);
  back.in_reverse = true;
  EXPECT_THAT(problems(LandmarkDriver::origin({}, back)),
              HasSubstr("route: 'there' is too short for a return path"));
  EXPECT_THAT(problems(LandmarkDriver::origin({}, {})), HasSubstr("building: is missing"));
  LandmarkMission damaged = mission();
  damaged.building.resize(50);
  EXPECT_THAT(problems(LandmarkDriver::origin({}, damaged)),
              HasSubstr("building:4: is not well-formed JSON"));
  Building bare = learned_building();
  bare.landmarks.assign({});
  EXPECT_THAT(problems(LandmarkDriver::origin({}, {.building = building_json(bare), .route = "there"})),
              HasSubstr("landmarks: are missing"));
}

TEST(LandmarkDriver, RefusesAnotherCameraAndBadParametersAtOnce) {
  SessionOrigin origin = LandmarkDriver::origin({}, mission());
  origin.parameters["look_s"] = "soon";
  VehicleDescription other = cart();
  other.cameras[0].intrinsics.fx_px = 600;
  other.cameras[0].mount.tilt_rad = 0;
  EXPECT_THAT(problems(origin, other),
              AllOf(HasSubstr("look_s: 'soon' is not a number"), HasSubstr("cameras.corridor.fx_px: is 600"),
                    HasSubstr("cameras.corridor.tilt_deg: is 0, but the landmarks were seen with 14")));
  other.cameras[0].name = "front";
  EXPECT_THAT(problems(origin, other), HasSubstr("cameras.corridor: is missing"));
}

}  // namespace
}  // namespace aisle
