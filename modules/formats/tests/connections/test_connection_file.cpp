#include <gmock/gmock.h>

#include <filesystem>

#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kConnectionHead = "format: aisle.connection\nversion: 1\nvehicle: cart\n";

std::string all_problems(const std::string& text) {
  const auto connection = parse_connection(text, "robot.yaml");
  return connection ? "read" : to_string(connection.problems());
}

TEST(ConnectionFile, AVehicleIsEnough) {
  const auto connection = parse_connection(kConnectionHead, "robot.yaml");
  ASSERT_TRUE(connection.ok()) << to_string(connection.problems());
  EXPECT_EQ(connection->vehicle, "cart");
  EXPECT_EQ(connection->topic(connection->scan.topic), "/scan");
  EXPECT_EQ(connection->network.interface_address, "127.0.0.1");
}

TEST(ConnectionFile, EveryPartMayBeGivenInPart) {
  const auto connection = parse_connection(std::string(kConnectionHead) +
                                               "network: {domain: 3}\nframes: {base: b}\nscan: {topic: s}\n"
                                               "odometry: {from: tf}\nbattery: {topic: b}\n"
                                               "command: {type: twist}\nlimits: {speed_max_mps: 0.2}\n",
                                           "robot.yaml");
  ASSERT_TRUE(connection.ok()) << to_string(connection.problems());
  EXPECT_EQ(connection->network.domain, 3);
  EXPECT_EQ(connection->network.interface_address, "127.0.0.1");
}

TEST(ConnectionFile, WhatIsWrittenIsReadAgain) {
  Connection connection = *parse_connection(kConnectionHead, "robot.yaml");
  connection.network = {7, "192.168.1.5", {"192.168.1.9", "robot.local"}, true, "/j100"};
  connection.clock = ConnectedClock::kRos;
  connection.frames = {"chassis", "odometry", ConnectedFrames::Mounts::kFile, {-0.125, 0.05}};
  connection.scan = {"front/scan", 0.5};
  connection.odometry = {"wheels", ConnectedOdometry::Source::kJointStates, 0.25, 0.1, "l", "r"};
  ConnectedCamera topic{.name = "front", .topic = "camera/image_raw", .calibration = "camera/lens"};
  topic.messages = ConnectedCamera::Messages::kCompressed;
  ConnectedCamera folder{.name = "rear", .silent_max_s = 3};
  folder.source.folder = "images";
  folder.source.rate_hz = 5;
  connection.cameras = {topic, folder};
  connection.joystick = {"pad", 5, 2, 3, -1, 7, 0.25, 40 * kDegree, 20 * kDegree};
  connection.bumpers = {{"bumper", 1}};
  connection.emergency_stops = {{"stop", 0}, {"platform/stop", 2}};
  connection.battery = {"battery", 0.3};
  connection.commands = {"drive", ConnectedCommands::Kind::kAckermann, 0.2};
  connection.limits = {0.4, 0.2, 30 * kDegree};
  const std::string text = connection_yaml(connection);
  const auto again = parse_connection(text, "robot.yaml");
  ASSERT_TRUE(again.ok()) << to_string(again.problems());
  EXPECT_EQ(connection_yaml(*again), text);
  EXPECT_EQ(again->network.peers, connection.network.peers);
  EXPECT_EQ(again->clock, ConnectedClock::kRos);
  EXPECT_EQ(again->frames.p_base_axle_m, connection.frames.p_base_axle_m);
  EXPECT_EQ(again->commands.kind, ConnectedCommands::Kind::kAckermann);
  EXPECT_NEAR(again->limits.turn_rate_max_rad_s, 30 * kDegree, 1e-9);
  EXPECT_EQ(again->emergency_stops.size(), 2U);
  ASSERT_EQ(again->cameras.size(), 2U);
  EXPECT_EQ(again->cameras[0].topic, "camera/image_raw");
  EXPECT_TRUE(again->cameras[0].has_compressed_images());
  EXPECT_EQ(again->cameras[1].source.folder, "images");
  EXPECT_EQ(again->cameras[1].source.rate_hz, 5);
  EXPECT_EQ(again->joystick.end_button, 7);
}

TEST(ConnectionFile, ACamerasCalibrationIsBesideItsImagesUnlessItIsNamed) {
  ConnectedCamera camera{.topic = "front/image_raw/compressed"};
  EXPECT_EQ(camera.calibration_topic(), "front/camera_info");
  EXPECT_TRUE(camera.has_compressed_images());
  camera.topic = "/image";
  EXPECT_EQ(camera.calibration_topic(), "/camera_info");
  EXPECT_FALSE(camera.has_compressed_images());
  camera.calibration = "lens";
  EXPECT_EQ(camera.calibration_topic(), "lens");
}

TEST(ConnectionFile, ACameraHasOneOriginAndANameOfItsOwn) {
  const std::string problems = all_problems(std::string(kConnectionHead) +
                                            "cameras:\n"
                                            "  - {topic: a, device: /dev/video0}\n"
                                            "  - {name: front}\n"
                                            "  - {name: a/b, topic: c}\n"
                                            "  - {name: net, url: ftp://there}\n");
  EXPECT_THAT(problems, HasSubstr("robot.yaml:5: cameras[0]: 2 of topic, device, url and folder are given"));
  EXPECT_THAT(problems, HasSubstr("robot.yaml:6: cameras[1].name: 'front' is the name of two cameras"));
  EXPECT_THAT(problems, HasSubstr("cameras[1]: 0 of topic, device, url and folder"));
  EXPECT_THAT(problems, HasSubstr("cameras[2].name: is not a camera name"));
  EXPECT_THAT(problems, HasSubstr("cameras[3].url: does not begin with rtsp://"));
}

TEST(ConnectionFile, AFileOfVersion1IsReadAndWrittenAsItIs) {
  const std::filesystem::path golden =
      std::filesystem::path(AISLE_SOURCE_DIR) / "tests/golden/connection.v1.yaml";
  const auto connection = read_connection(golden);
  ASSERT_TRUE(connection.ok()) << to_string(connection.problems());
  EXPECT_EQ(connection_yaml(*connection), *read_whole_file(golden));
}

TEST(ConnectionFile, TopicsAreInTheNamespaceUnlessTheyBeginWithASlash) {
  Connection connection;
  connection.network.name_space = "j100/";
  EXPECT_EQ(connection.topic("scan"), "/j100/scan");
  EXPECT_EQ(connection.topic("/scan"), "/scan");
  connection.network.name_space = "/j100";
  EXPECT_EQ(connection.topic("a/scan"), "/j100/a/scan");
}

TEST(ConnectionFile, AllProblemsAreReportedWithTheirPlaces) {
  const std::string problems = all_problems(
      "format: aisle.connection\nversion: 1\nclock: wall\nscan: {topc: scan}\nodometry: {jump_max_m: -1}\n"
      "network: {domain: 200, peers: 127.0.0.1}\nbumpers: [{silent_max_s: 1}]\n");
  EXPECT_THAT(problems, HasSubstr("robot.yaml:1: vehicle: is missing"));
  EXPECT_THAT(problems, HasSubstr("robot.yaml:3: clock: 'wall' is none of stamps, ros, arrival"));
  EXPECT_THAT(problems, HasSubstr("robot.yaml:4: scan.topc: unknown key"));
  EXPECT_THAT(problems, HasSubstr("robot.yaml:5: odometry.jump_max_m: -1 is outside"));
  EXPECT_THAT(problems, HasSubstr("network.domain: 200 is outside 0 .. 101"));
  EXPECT_THAT(problems, HasSubstr("network.peers: is not a list"));
  EXPECT_THAT(problems, HasSubstr("bumpers[0].topic: is missing"));
}

TEST(ConnectionFile, ALimitMayOnlyLowerTheVehicles) {
  const DriveLimits vehicle;
  Connection connection;
  connection.file = "robot.yaml";
  EXPECT_EQ(limits_over(connection, vehicle)->speed_max_mps, vehicle.speed_max_mps);
  connection.limits.speed_max_mps = 0.3;
  EXPECT_EQ(limits_over(connection, vehicle)->speed_max_mps, 0.3);
  connection.limits.speed_max_mps = 3;
  EXPECT_THAT(to_string(limits_over(connection, vehicle).problems()),
              HasSubstr("robot.yaml: limits.speed_max_mps: 3 is above the vehicle's own limit of 1"));
}

}  // namespace
}  // namespace aisle
