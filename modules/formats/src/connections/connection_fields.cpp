#include "connections/connection_fields.hpp"

#include <array>

#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr int kDomainMax = 101;  // the ports of a larger one are given to other programs by Linux
constexpr Range kSilence_s = {0.05, 60};
constexpr Range kControl = {0, 63};  // axes and buttons of a joystick
constexpr Range kButton = {-1, 63};

constexpr std::array<std::string_view, 3> kClocks = {"stamps", "ros", "arrival"};
constexpr std::array<std::string_view, 2> kMounts = {"tf", "file"};
constexpr std::array<std::string_view, 3> kSources = {"odometry", "tf", "joint_states"};
constexpr std::array<std::string_view, 3> kMessages = {"auto", "image", "compressed"};
constexpr std::array<std::string_view, 4> kKinds = {"auto", "twist", "twist_stamped", "ackermann"};

}  // namespace

ObjectFields fields_of(ConnectedNetwork& network) {
  return {field::count("domain", network.domain, {0, kDomainMax}),
          field::text("interface", network.interface_address), field::flag("multicast", network.multicast),
          field::text("namespace", network.name_space)};
}

ObjectFields fields_of(ConnectedFrames& frames) {
  return {field::text("base", frames.base), field::text("odom", frames.odom),
          field::word("mounts", frames.mounts, kMounts),
          field::point("axle_m", frames.p_base_axle_m, {-5, 5})};
}

ObjectFields fields_of(ConnectedScan& scan) {
  return {field::text("topic", scan.topic), field::number("silent_max_s", scan.silent_max_s, kSilence_s)};
}

ObjectFields fields_of(ConnectedCamera& camera) {
  CameraSource& source = camera.source;
  return {field::text("name", camera.name),
          field::text("topic", camera.topic),
          field::word("messages", camera.messages, kMessages),
          field::text("calibration", camera.calibration),
          field::text("device", source.device),
          field::text("url", source.url),
          field::text("folder", source.folder),
          field::number("rate_hz", source.rate_hz, {0.01, 1000}),
          field::number("exposure_offset_s", source.exposure_offset_s, {-5, 5}),
          field::number("silent_max_s", camera.silent_max_s, kSilence_s)};
}

ObjectFields fields_of(ConnectedOdometry& odometry) {
  return {field::text("topic", odometry.topic),
          field::word("from", odometry.source, kSources),
          field::number("silent_max_s", odometry.silent_max_s, kSilence_s),
          field::number("jump_max_m", odometry.jump_max_m, {0.01, 10}),
          field::text("left_joint", odometry.left_joint),
          field::text("right_joint", odometry.right_joint)};
}

ObjectFields fields_of(ConnectedSwitch& bumper_or_stop) {
  return {needed(field::text("topic", bumper_or_stop.topic)),
          field::number("silent_max_s", bumper_or_stop.silent_max_s, {0, 60})};
}

ObjectFields fields_of(ConnectedBattery& battery) {
  return {field::text("topic", battery.topic), field::number("charge_min", battery.charge_min, {0, 1})};
}

ObjectFields fields_of(ConnectedJoystick& joystick) {
  return {field::text("topic", joystick.topic),
          field::count("dead_man_button", joystick.dead_man_button, kControl),
          field::count("speed_axis", joystick.speed_axis, kControl),
          field::count("turn_axis", joystick.turn_axis, kControl),
          field::count("place_button", joystick.place_button, kButton),
          field::count("end_button", joystick.end_button, kButton),
          field::number("speed_mps", joystick.speed_mps, {0.01, 10}),
          field::angle("turn_rate_deg_s", joystick.turn_rate_rad_s, {1, 1000}),
          field::angle("steering_deg", joystick.steering_rad, {1, 89})};
}

ObjectFields fields_of(ConnectedCommands& commands) {
  return {field::text("topic", commands.topic), field::word("type", commands.kind, kKinds),
          field::number("age_max_s", commands.age_max_s, {0.05, 1})};
}

ObjectFields fields_of(ConnectedLimits& limits) {
  return {field::number("speed_max_mps", limits.speed_max_mps, {0, 10}),
          field::number("reverse_speed_max_mps", limits.reverse_speed_max_mps, {0, 10}),
          field::angle("turn_rate_max_deg_s", limits.turn_rate_max_rad_s, {0, 1000})};
}

ObjectFields fields_of(Connection& connection) {
  return {needed(field::text("vehicle", connection.vehicle)),
          field::word("clock", connection.clock, kClocks)};
}

}  // namespace aisle
