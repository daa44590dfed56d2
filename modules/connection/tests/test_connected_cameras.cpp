/// Cameras of a connected vehicle.
#include <gmock/gmock.h>

#include <filesystem>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/connection/robot_check.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "scripted_robot.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ConnectedCamerasTest : public testing::Test {
 protected:
  ConnectedCamerasTest() {
    ConnectedCamera camera;
    camera.topic = "camera/image_raw";
    connection.cameras = {camera};
    robot.sends_images = true;
  }

  void leave_out_the_scanner() {
    connection.scan.topic.clear();
    robot.sends_scans = false;
  }
  CameraDescription in_file() const {
    CameraDescription camera;
    camera.width_px = ScriptedRobot::kImageWidth_px;
    camera.height_px = ScriptedRobot::kImageHeight_px;
    camera.intrinsics.fx_px = camera.intrinsics.fy_px = 70;
    camera.intrinsics.cx_px = 31.5;
    camera.intrinsics.cy_px = 23.5;
    camera.mount.p_vehicle_camera = {0.1, 0, 0.8};
    return camera;
  }
  Result<std::unique_ptr<ConnectedVehicle>> connect() {
    return ConnectedVehicle::connect(connection, vehicle, {robot.wire, robot.clock, robot, robot.noting()});
  }
  std::string problems_of_connecting() {
    const auto connected = connect();
    return connected ? "connected" : to_string(connected.problems());
  }
  static int shade_of(const CameraImage& image) { return image.pixels->bytes.front(); }

  ScriptedRobot robot;
  Connection connection = plain_connection();
  VehicleDescription vehicle = cart();
};

TEST_F(ConnectedCamerasTest, LensAndMountAreWhatTheRobotSays) {
  const auto connected = connect();
  ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
  ASSERT_THAT((*connected)->description().cameras, SizeIs(1));
  const CameraDescription& camera = (*connected)->description().cameras.front();
  EXPECT_EQ(camera.name, "front");
  EXPECT_EQ(camera.width_px, 64);
  EXPECT_EQ(camera.intrinsics.fx_px, 60);
  EXPECT_NEAR(camera.period_s, 0.1, 1e-6);
  EXPECT_NEAR((camera.mount.p_vehicle_camera - Vec3(0.2, 0, 0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR(camera.mount.tilt_rad, 0, 1e-6);
}

TEST_F(ConnectedCamerasTest, TheAxleMayLieElsewhereThanTheRobotsBaseFrame) {
  connection.frames.p_base_axle_m = {-0.2, 0.1};
  const auto connected = connect();
  EXPECT_NEAR(
      ((*connected)->description().cameras.front().mount.p_vehicle_camera - Vec3(0.4, -0.1, 0.5)).norm(), 0,
      1e-9);
}

TEST_F(ConnectedCamerasTest, WithoutAScannerAnImageEndsTheCycle) {
  leave_out_the_scanner();
  const auto connected = connect();
  ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
  EXPECT_FALSE((*connected)->description().scanner);
  EXPECT_NEAR((*connected)->description().cycle_s, 0.1, 1e-6);
  double driven_m = 0;
  for (int i = 1; i <= 10; ++i) {
    const auto observation = (*connected)->sense();
    ASSERT_THAT(observation->images, SizeIs(1));
    EXPECT_FALSE(observation->scan);
    EXPECT_NEAR(observation->stamp_s, 0.1 * i, 1e-6);
    EXPECT_NEAR(observation->images.front().stamp_s, observation->stamp_s, 1e-9);
    EXPECT_EQ(shade_of(observation->images.front()), robot.images - 1) << "the newest";
    if (i > 1) driven_m += odometry_step((*connected)->description(), observation->odometry).x;
  }
  EXPECT_NEAR(driven_m, 9 * 0.1 * 0.3, 0.005);
}

TEST_F(ConnectedCamerasTest, AScanThatEndsTheCycleComesWithTheImageBeforeIt) {
  const auto connected = connect();
  const auto first = (*connected)->sense();
  ASSERT_TRUE(first->scan);
  const auto second = (*connected)->sense();
  ASSERT_THAT(second->images, SizeIs(1));
  EXPECT_LE(second->images.front().stamp_s, second->stamp_s + 1e-9);
}

TEST_F(ConnectedCamerasTest, ImagesThatWaitTooLongAreSkipped) {
  leave_out_the_scanner();
  const auto connected = connect();
  (*connected)->sense();
  for (int i = 0; i < 25; ++i) robot.report({}, 0, 0);  // the mission thinks for half a second
  const auto late = (*connected)->sense();
  EXPECT_EQ(shade_of(late->images.front()), robot.images - 1);
  EXPECT_GE((*connected)->counts().images_skipped, 3U);
}

TEST_F(ConnectedCamerasTest, SilentImagesEndTheMissionByName) {
  leave_out_the_scanner();
  const auto connected = connect();
  (*connected)->sense();
  robot.sends_images = false;
  while ((*connected)->sense()) {
  }
  EXPECT_THAT(robot.notes, testing::Contains("held: /camera/image_raw is far behind /odom"));
  EXPECT_EQ((*connected)->end_reason(), "/camera/image_raw silent for 1.0 s");
}

TEST_F(ConnectedCamerasTest, ImagesWhoseStampsJumpAheadHoldTheVehicleForASecond) {
  leave_out_the_scanner();
  const auto connected = connect();
  const double before_s = (*connected)->sense()->stamp_s;
  const long from = robot.ticks;
  robot.stamp_s += 50;
  const auto after = (*connected)->sense();
  EXPECT_GE(robot.ticks - from, 50);
  EXPECT_NEAR(after->stamp_s, before_s + 0.1, 0.02);
  EXPECT_EQ((*connected)->counts().clock_gaps, 1U);
  EXPECT_THAT(robot.notes, testing::Contains(HasSubstr("jumped ahead by 50.0 s")));
}

TEST_F(ConnectedCamerasTest, ImagesWhoseStampsJumpBackEndTheMission) {
  leave_out_the_scanner();
  connection.odometry.topic = "wheel_odom";  // whose stamps stay as they are
  robot.script = [&] {
    ros::Odometry odometry;
    odometry.header = robot.header("odom");
    odometry.header.stamp = ros::time_of(ros::stamp_ns(5000 + 0.02 * static_cast<double>(robot.ticks)));
    odometry.pose.pose.orientation = {0, 0, 0, 1};
    robot.wire.tell("/wheel_odom", cdr_bytes(odometry));
  };
  const auto connected = connect();
  ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
  (*connected)->sense();
  robot.stamp_s -= 100;
  while ((*connected)->sense()) {
  }
  EXPECT_THAT((*connected)->end_reason(), HasSubstr("the stamps of /camera/image_raw jumped back by 99.9 s"));
}

TEST_F(ConnectedCamerasTest, SilentImagesEndAMissionThatAScannerLeadsToo) {
  const auto connected = connect();
  (*connected)->sense();
  robot.sends_images = false;
  while ((*connected)->sense()) {
  }
  EXPECT_EQ((*connected)->end_reason(), "/camera/image_raw silent for 1.0 s");
}

TEST_F(ConnectedCamerasTest, ALensThatDiffersFromTheVehicleFilesIsSaid) {
  vehicle.cameras = {in_file()};
  const auto connected = connect();
  ASSERT_TRUE(connected.ok());
  EXPECT_EQ((*connected)->description().cameras.front().intrinsics.fx_px, 60);
  EXPECT_THAT(robot.notes, testing::Contains(HasSubstr("cameras.front.fx_px differs")));
}

TEST_F(ConnectedCamerasTest, WithoutCalibrationTheVehicleFilesLensIsTaken) {
  robot.sends_calibration = false;
  vehicle.cameras = {in_file()};
  connection.frames.mounts = ConnectedFrames::Mounts::kFile;
  vehicle.scanner = LaserScanner{-1, 0.5, 8, Pose2{}};
  const auto connected = connect();
  ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
  EXPECT_EQ((*connected)->description().cameras.front().intrinsics.fx_px, 70);
  EXPECT_EQ((*connected)->description().cameras.front().mount.p_vehicle_camera.z(), 0.8);
}

TEST_F(ConnectedCamerasTest, ALensThatNobodySaysIsRefused) {
  robot.sends_calibration = false;
  EXPECT_THAT(problems_of_connecting(), HasSubstr("/camera/camera_info: nothing came on it"));
  vehicle.cameras = {in_file()};
  vehicle.cameras.front().width_px = 640;
  EXPECT_THAT(problems_of_connecting(), HasSubstr("nobody says the lens of these images of 64 x 48 pixels"));
}

TEST_F(ConnectedCamerasTest, AnImpossibleCalibrationIsRefusedWithItsReason) {
  robot.focal_px = 0;  // drivers without a calibration send zeros
  EXPECT_THAT(problems_of_connecting(), HasSubstr("its calibration is not taken: fx_px 0 is outside"));
}

TEST_F(ConnectedCamerasTest, AMountThatNobodySaysIsRefused) {
  leave_out_the_scanner();
  robot.has_mount = false;
  EXPECT_THAT(problems_of_connecting(), HasSubstr("no fixed transforms lead from 'base_link' to "
                                                  "'camera_optical', the frame of the images"));
}

TEST_F(ConnectedCamerasTest, ImagesThatNobodyPublishesAreRefused) {
  robot.sends_images = false;
  EXPECT_THAT(problems_of_connecting(),
              HasSubstr("/camera/image_raw: nobody publishes it as sensor_msgs/msg/Image"));
}

TEST_F(ConnectedCamerasTest, AnEncodingThatIsNotReadIsRefusedByName) {
  robot.image_encoding = "32FC1";
  EXPECT_THAT(problems_of_connecting(), HasSubstr("'32FC1'"));
}

TEST_F(ConnectedCamerasTest, ImagesThatCannotBeReadEndTheMission) {
  leave_out_the_scanner();
  const auto connected = connect();
  (*connected)->sense();
  robot.image_encoding = "mono16";
  while ((*connected)->sense()) {
  }
  EXPECT_THAT((*connected)->end_reason(),
              HasSubstr("cannot be read, the last of them sensor_msgs/msg/Image"));
}

TEST_F(ConnectedCamerasTest, WithoutATopicOfCommandsNothingIsSent) {
  connection.commands.topic.clear();
  robot.wire.endpoints_of_others.clear();
  {
    const auto connected = connect();
    ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
    (*connected)->sense();
    (*connected)->act({.speed_mps = 1});
  }
  EXPECT_THAT(robot.wire.advertised, IsEmpty());
}

TEST_F(ConnectedCamerasTest, ACameraThatAisleOpensItselfNeedsTheVehicleFile) {
  connection.cameras.front().topic.clear();
  connection.cameras.front().source.folder = "images";
  EXPECT_THAT(problems_of_connecting(),
              HasSubstr("robot.yaml: cameras[0]: the vehicle file has no camera 'front'"));
}

TEST_F(ConnectedCamerasTest, AFolderIsShownBesideARobot) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "connected_images";
  std::filesystem::create_directories(folder);
  ASSERT_THAT(write_whole_file(folder / "0.png", png_bytes(Image(64, 48))), IsEmpty());
  ASSERT_THAT(write_whole_file(folder / "1.png", png_bytes(Image(64, 48))), IsEmpty());
  leave_out_the_scanner();
  vehicle.cameras = {in_file()};
  connection.file = (folder.parent_path() / "robot.yaml").string();
  connection.clock = ConnectedClock::kArrival;
  ConnectedCamera& camera = connection.cameras.front();
  camera.topic.clear();
  camera.source.folder = "connected_images";
  camera.source.rate_hz = 100;
  camera.source.loops = true;
  const SteadyClock clock;
  const auto connected =
      ConnectedVehicle::connect(connection, vehicle, {robot.wire, clock, robot, robot.noting()});
  ASSERT_TRUE(connected.ok()) << to_string(connected.problems());
  EXPECT_EQ((*connected)->description().cameras.front().intrinsics.fx_px, 70);
  EXPECT_THAT((*connected)->sense()->images, SizeIs(1));
}

TEST_F(ConnectedCamerasTest, TheCheckSaysWhereLensAndMountAreFrom) {
  const auto check = check_robot(connection, vehicle, {robot.wire, robot.clock, robot, robot.noting()}, 2);
  ASSERT_TRUE(check.ok()) << to_string(check.problems());
  ASSERT_THAT(check->cameras, SizeIs(1));
  EXPECT_EQ(check->cameras[0].lens_from, "/camera/camera_info");
  EXPECT_EQ(check->cameras[0].mount_from, "/tf_static");
  EXPECT_NEAR(check->cameras[0].pace.rate_hz(), 10, 0.5);
}

}  // namespace
}  // namespace aisle
