#include "telemetry.hpp"

namespace robots {
namespace {

Quaternion about_z(double angle_rad) {
  return {0, 0, std::sin(angle_rad / 2), std::cos(angle_rad / 2)};
}

/// Of a frame whose z looks forwards and down by the tilt, x right and y down.
Quaternion optical(double tilt_rad) {
  const double s = std::sin(tilt_rad / 2), c = std::cos(tilt_rad / 2);
  return {-(c + s) / 2, (c + s) / 2, (s - c) / 2, (c - s) / 2};
}

std::vector<const char*> joint_names(const Vehicle& vehicle) {
  if (!vehicle.is_steered()) return {"left_wheel", "right_wheel"};
  return {"left_wheel",     "right_wheel",      "left_steering",
          "right_steering", "left_front_wheel", "right_front_wheel"};
}

std::vector<std::uint8_t> grey(const std::vector<std::uint8_t>& rgb) {
  std::vector<std::uint8_t> shades(rgb.size() / 3);
  for (std::size_t i = 0; i < shades.size(); ++i) {
    shades[i] =
        static_cast<std::uint8_t>((77 * rgb[3 * i] + 150 * rgb[3 * i + 1] + 29 * rgb[3 * i + 2]) >> 8);
  }
  return shades;
}

}  // namespace

Telemetry::Telemetry(const Participant& participant, const Options& options, const Vehicle& vehicle)
    : vehicle_(vehicle),
      tf_(participant, options.ros_namespace + "/tf", Quality::kDefault),
      tf_static_(participant, options.ros_namespace + "/tf_static", Quality::kLatched),
      odometry_(participant, options.ros_namespace + "/odom", Quality::kDefault),
      joints_(participant, options.ros_namespace + "/joint_states", Quality::kDefault),
      bumper_(participant, options.ros_namespace + "/bumper", Quality::kDefault),
      scan_(participant, options.ros_namespace + "/scan", Quality::kSensor) {
  if (options.simulated_clock) clock_.emplace(participant, "/clock", Quality::kSensor);
  if (!options.camera) return;
  const std::string camera = options.ros_namespace + "/camera/";
  camera_.emplace(CameraTopics{*options.camera,
                               {participant, camera + "image_raw", Quality::kSensor},
                               {participant, camera + "camera_info", Quality::kSensor}});
}

void Telemetry::publish_mounts(const Time& stamp) const {
  const Header header{stamp, "base_link"};
  TFMessage mounts;
  mounts.transforms.push_back({header, "laser", {vehicle_.laser_x_m, 0, vehicle_.laser_z_m}, {}});
  if (camera_) {
    mounts.transforms.push_back({header,
                                 "camera_optical",
                                 {vehicle_.camera_x_m, 0, vehicle_.camera_z_m},
                                 optical(vehicle_.camera_tilt_rad)});
  }
  tf_static_.publish(mounts);
}

void Telemetry::publish_clock(const Time& stamp) const {
  if (clock_) clock_->publish({stamp});
}

void Telemetry::publish_odometry(const Time& stamp, const WheelOdometry& odometry) const {
  const Pose2& T_odom_vehicle = odometry.T_odom_vehicle();
  Odometry message;
  message.header = {stamp, "odom"};
  message.child_frame_id = "base_link";
  message.pose.position = {T_odom_vehicle.x, T_odom_vehicle.y, 0};
  message.pose.orientation = about_z(T_odom_vehicle.heading_rad);
  message.twist.linear.x = odometry.speed_mps();
  message.twist.angular.z = odometry.turn_rate_radps();
  odometry_.publish(message);
  tf_.publish({{{message.header, "base_link", message.pose.position, message.pose.orientation}}});
}

void Telemetry::publish_joints(const Time& stamp, const Physics& physics) const {
  JointState message;
  message.header.stamp = stamp;
  for (const char* name : joint_names(vehicle_)) {
    const JointReading reading = physics.joint(name);
    message.name.emplace_back(name);
    message.position.push_back(reading.angle_rad);
    message.velocity.push_back(reading.rate_radps);
  }
  joints_.publish(message);
}

void Telemetry::publish_bumper(bool pressed) const {
  bumper_.publish({pressed});
}

void Telemetry::publish_scan(const Time& stamp, const RangeScanner& scanner, std::vector<float> ranges,
                             double period_s) const {
  const double last_beam = static_cast<double>(ranges.size()) - 1;
  LaserScan message;
  message.header = {stamp, "laser"};
  message.angle_min = static_cast<float>(RangeScanner::kFirstAngle_rad);
  message.angle_max =
      static_cast<float>(RangeScanner::kFirstAngle_rad + last_beam * scanner.angle_step_rad());
  message.angle_increment = static_cast<float>(scanner.angle_step_rad());
  message.scan_time = static_cast<float>(period_s);
  message.range_min = static_cast<float>(RangeScanner::kRangeMin_m);
  message.range_max = static_cast<float>(scanner.range_max_m());
  message.ranges = std::move(ranges);
  scan_.publish(message);
}

void Telemetry::publish_image(const Time& stamp, const std::vector<std::uint8_t>& pixels) const {
  Image message;
  message.header = {stamp, "camera_optical"};
  message.width = static_cast<std::uint32_t>(camera_->size.width_px);
  message.height = static_cast<std::uint32_t>(camera_->size.height_px);
  message.encoding = "mono8";
  message.step = message.width;
  message.data = grey(pixels);
  camera_->image.publish(message);
  camera_->info.publish(camera_info(stamp));
}

/// A pinhole; pixels are counted from the centre of the first one.
CameraInfo Telemetry::camera_info(const Time& stamp) const {
  const double width = camera_->size.width_px, height = camera_->size.height_px;
  const double focal_px = height / 2 / std::tan(vehicle_.camera_fovy_rad / 2);
  const double cx = (width - 1) / 2, cy = (height - 1) / 2;
  CameraInfo message;
  message.header = {stamp, "camera_optical"};
  message.width = static_cast<std::uint32_t>(width);
  message.height = static_cast<std::uint32_t>(height);
  message.distortion_model = "plumb_bob";
  message.d.resize(5);
  message.k = {focal_px, 0, cx, 0, focal_px, cy, 0, 0, 1};
  message.r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  message.p = {focal_px, 0, cx, 0, 0, focal_px, cy, 0, 0, 0, 1, 0};
  return message;
}

}  // namespace robots
