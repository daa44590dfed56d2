#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "fake_wire.hpp"

namespace aisle {

/// A robot at the other end of the wire. It lives while the vehicle waits: twenty milliseconds each time.
class ScriptedRobot final : public Progress {
 public:
  ScriptedRobot() {
    wire.endpoints_of_others = {
        {WireEndpoint::Kind::kSubscriber, "/cmd_vel", "geometry_msgs/msg/Twist", true, false, "robot"},
        {WireEndpoint::Kind::kPublisher, "/scan", "sensor_msgs/msg/LaserScan", false, false, "robot"}};
  }

  void report(std::string_view, std::size_t, std::size_t) override {
    clock.move(kTick_s);
    stamp_s += kTick_s;
    move();
    ++ticks;
    tell_mount();  // also wakes whoever waits, when nothing else is sent
    if (script) script();
    if (sends_odometry) tell_odometry();
    if (ticks % 5 == 0 && sends_scans) tell_scan();
    if (ticks % 5 == 0 && sends_images) tell_image();
  }

  /// Its grey is how many images came before it.
  void tell_image() {
    ros::Image image;
    image.header = header("camera_optical");
    image.width = image.step = kImageWidth_px;
    image.height = kImageHeight_px;
    image.encoding = image_encoding;
    image.data.assign(std::size_t{kImageWidth_px} * kImageHeight_px, static_cast<std::uint8_t>(images));
    ++images;
    wire.tell("/camera/image_raw", cdr_bytes(image));
    if (!sends_calibration) return;
    ros::CameraInfo info;
    info.header = image.header;
    info.width = image.width;
    info.height = image.height;
    info.distortion_model = "plumb_bob";
    info.d.resize(5);
    info.k = {focal_px, 0, 31.5, 0, focal_px, 23.5, 0, 0, 1};
    wire.tell("/camera/camera_info", cdr_bytes(info));
  }

  void tell_mount() {
    ros::TransformStamped camera;
    camera.header.frame_id = "base_link";
    camera.child_frame_id = "camera_optical";
    camera.transform.translation = {0.2, 0, 0.5};
    camera.transform.rotation = {-0.5, 0.5, -0.5, 0.5};  // looks ahead
    if (has_mount) wire.tell("/tf_static", cdr_bytes(ros::TFMessage{{camera}}));
    ros::TransformStamped mount;
    mount.header.frame_id = "base_link";
    mount.child_frame_id = "laser";
    mount.transform.translation = {0.1, 0, 0.2};
    if (is_upside_down) mount.transform.rotation = {1, 0, 0, 0};
    if (!has_mount) mount.child_frame_id = "camera";
    wire.tell("/tf_static", cdr_bytes(ros::TFMessage{{mount}}));
  }
  void tell_odometry() {
    ros::Odometry odometry;
    odometry.header = header("odom");
    odometry.pose.pose.position = {T_odom_base.x, T_odom_base.y, 0};
    odometry.pose.pose.orientation = {0, 0, std::sin(T_odom_base.theta / 2), std::cos(T_odom_base.theta / 2)};
    wire.tell("/odom", cdr_bytes(odometry));
  }
  void tell_scan() {
    ros::LaserScan scan;
    scan.header = header("laser");
    scan.angle_min = -1;
    scan.angle_max = 1;
    scan.angle_increment = 0.5;
    scan.range_min = 0.1F;
    scan.range_max = 8;
    scan.time_increment = time_increment_s;
    scan.ranges = {1, 2, 3, HUGE_VALF, NAN};
    if (stands_in_a_room) look_around(scan);
    wire.tell("/scan", cdr_bytes(scan));
  }
  void tell_stop(bool is_pressed) { wire.tell("/stop", cdr_bytes(ros::Bool{is_pressed})); }
  std::function<void(const std::string&)> noting() {
    return [this](const std::string& note) { notes.push_back(note); };
  }
  ros::Header header(const std::string& frame) const { return {ros::time_of(ros::stamp_ns(stamp_s)), frame}; }

  static constexpr std::uint32_t kImageWidth_px = 64, kImageHeight_px = 48;

  FakeWire wire;
  MovedClock clock;
  double stamp_s = 5000;  // by the robot's clock
  Pose2 T_odom_base{2, 1, kPi / 2};
  double speed_mps = 0.3;
  bool sends_odometry = true;
  bool sends_scans = true;
  bool sends_images = false;
  bool sends_calibration = true;
  std::string image_encoding = "mono8";
  double focal_px = 60;
  int images = 0;  ///< sent so far
  bool has_mount = true;
  bool is_upside_down = false;
  float time_increment_s = 0;
  long ticks = 0;
  std::function<void()> script;  ///< at every tick
  std::vector<std::string> notes;

  bool follows_commands = false;  ///< else it drives at speed_mps
  bool stops_by_itself = true;    ///< when commands no longer come
  double turn_sign = 1;           ///< of what it makes of commands
  double odometry_scale = 1;
  bool stands_in_a_room = false;
  double front_wall_m = 2;  ///< from where it started

 private:
  static constexpr double kTick_s = 0.02;

  void move() {
    Pose2 step{speed_mps * kTick_s, 0, 0};
    if (follows_commands) {
      const auto topic = wire.sent("/cmd_vel");
      if (ticks % 5 == 0 && wire.advertised.count("/cmd_vel") > 0)
        topic->await_more_than(commands_);  // it has its own thread
      const auto sent = topic->all();
      is_silent_for_s_ = sent.size() == commands_ ? is_silent_for_s_ + kTick_s : 0;
      commands_ = sent.size();
      const bool is_given_up = stops_by_itself && is_silent_for_s_ > 0.3;
      const auto twist = sent.empty() || is_given_up ? ros::Twist{} : *parse_cdr<ros::Twist>(sent.back());
      step = end_pose({twist.linear.x * kTick_s, turn_sign * twist.angular.z * kTick_s});
    }
    T_room_base_ = T_room_base_ * step;
    T_odom_base = T_odom_base * Pose2{odometry_scale * step.x, step.y, step.theta};
  }

  /// A room of 4.5 m by 3 m about the start, seen all round.
  void look_around(ros::LaserScan& scan) const {
    constexpr int kBeams = 360;
    scan.angle_min = static_cast<float>(-kPi);
    scan.angle_increment = static_cast<float>(2 * kPi / kBeams);
    scan.angle_max = scan.angle_min + (kBeams - 1) * scan.angle_increment;
    scan.ranges.clear();
    const Pose2 T = T_room_base_ * Pose2{0.1, 0, 0};
    for (int i = 0; i < kBeams; ++i) {
      const Vec2 beam = unit(T.theta + scan.angle_min + i * double{scan.angle_increment});
      const double along_m = beam.x() > 0 ? (front_wall_m - T.x) / beam.x() : (-2.5 - T.x) / beam.x();
      const double across_m = beam.y() > 0 ? (1.4 - T.y) / beam.y() : (-1.6 - T.y) / beam.y();
      scan.ranges.push_back(static_cast<float>(std::min(along_m, across_m)));
    }
  }

  Pose2 T_room_base_;
  std::size_t commands_ = 0;
  double is_silent_for_s_ = 0;
};

inline Connection plain_connection() {
  return *parse_connection("format: aisle.connection\nversion: 1\nvehicle: cart\n", "robot.yaml");
}

inline VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

}  // namespace aisle
