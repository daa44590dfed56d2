#pragma once
/// The ROS 2 messages that a robot speaks, their members in the order of the specifications.

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace robots {

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  double seconds() const { return sec + 1e-9 * nanosec; }
  static auto fields(auto& m) { return std::tie(m.sec, m.nanosec); }
};

struct Header {
  Time stamp;
  std::string frame_id;

  static auto fields(auto& m) { return std::tie(m.stamp, m.frame_id); }
};

struct Bool {
  static constexpr const char* kType = "std_msgs/msg/Bool";
  bool data = false;

  static auto fields(auto& m) { return std::tie(m.data); }
};

struct Clock {
  static constexpr const char* kType = "rosgraph_msgs/msg/Clock";
  Time clock;

  static auto fields(auto& m) { return std::tie(m.clock); }
};

struct Vector3 {
  double x = 0, y = 0, z = 0;

  static auto fields(auto& m) { return std::tie(m.x, m.y, m.z); }
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;

  static auto fields(auto& m) { return std::tie(m.x, m.y, m.z, m.w); }
};

struct Pose {
  Vector3 position;
  Quaternion orientation;

  static auto fields(auto& m) { return std::tie(m.position, m.orientation); }
};

struct Twist {
  static constexpr const char* kType = "geometry_msgs/msg/Twist";
  Vector3 linear, angular;

  static auto fields(auto& m) { return std::tie(m.linear, m.angular); }
};

struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TwistStamped";
  Header header;
  Twist twist;

  static auto fields(auto& m) { return std::tie(m.header, m.twist); }
};

struct AckermannDriveStamped {
  static constexpr const char* kType = "ackermann_msgs/msg/AckermannDriveStamped";
  Header header;
  float steering_angle = 0, steering_angle_velocity = 0, speed = 0, acceleration = 0, jerk = 0;

  static auto fields(auto& m) {
    return std::tie(m.header, m.steering_angle, m.steering_angle_velocity, m.speed, m.acceleration, m.jerk);
  }
};

struct Odometry {
  static constexpr const char* kType = "nav_msgs/msg/Odometry";
  Header header;
  std::string child_frame_id;
  Pose pose;
  std::array<double, 36> pose_covariance{};
  Twist twist;
  std::array<double, 36> twist_covariance{};

  static auto fields(auto& m) {
    return std::tie(m.header, m.child_frame_id, m.pose, m.pose_covariance, m.twist, m.twist_covariance);
  }
};

struct TransformStamped {
  Header header;
  std::string child_frame_id;
  Vector3 translation;
  Quaternion rotation;

  static auto fields(auto& m) { return std::tie(m.header, m.child_frame_id, m.translation, m.rotation); }
};

struct TFMessage {
  static constexpr const char* kType = "tf2_msgs/msg/TFMessage";
  std::vector<TransformStamped> transforms;

  static auto fields(auto& m) { return std::tie(m.transforms); }
};

struct Joy {
  static constexpr const char* kType = "sensor_msgs/msg/Joy";
  Header header;
  std::vector<float> axes;
  std::vector<std::int32_t> buttons;

  static auto fields(auto& m) { return std::tie(m.header, m.axes, m.buttons); }
};

struct JointState {
  static constexpr const char* kType = "sensor_msgs/msg/JointState";
  Header header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;

  static auto fields(auto& m) { return std::tie(m.header, m.name, m.position, m.velocity, m.effort); }
};

struct PoseStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseStamped";
  Header header;
  Pose pose;

  static auto fields(auto& m) { return std::tie(m.header, m.pose); }
};

struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovarianceStamped";
  Header header;
  Pose pose;
  std::array<double, 36> covariance{};

  static auto fields(auto& m) { return std::tie(m.header, m.pose, m.covariance); }
};

struct KeyValue {
  std::string key, value;

  static auto fields(auto& m) { return std::tie(m.key, m.value); }
};

struct DiagnosticStatus {
  std::uint8_t level = 0;
  std::string name, message, hardware_id;
  std::vector<KeyValue> values;

  static auto fields(auto& m) { return std::tie(m.level, m.name, m.message, m.hardware_id, m.values); }
};

struct DiagnosticArray {
  static constexpr const char* kType = "diagnostic_msgs/msg/DiagnosticArray";
  Header header;
  std::vector<DiagnosticStatus> status;

  static auto fields(auto& m) { return std::tie(m.header, m.status); }
};

struct LaserScan {
  static constexpr const char* kType = "sensor_msgs/msg/LaserScan";
  Header header;
  float angle_min = 0, angle_max = 0, angle_increment = 0;
  float time_increment = 0, scan_time = 0;
  float range_min = 0, range_max = 0;
  std::vector<float> ranges, intensities;

  static auto fields(auto& m) {
    return std::tie(m.header, m.angle_min, m.angle_max, m.angle_increment, m.time_increment, m.scan_time,
                    m.range_min, m.range_max, m.ranges, m.intensities);
  }
};

struct Image {
  static constexpr const char* kType = "sensor_msgs/msg/Image";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  std::vector<std::uint8_t> data;

  static auto fields(auto& m) {
    return std::tie(m.header, m.height, m.width, m.encoding, m.is_bigendian, m.step, m.data);
  }
};

struct RegionOfInterest {
  std::uint32_t x_offset = 0, y_offset = 0, height = 0, width = 0;
  bool do_rectify = false;

  static auto fields(auto& m) { return std::tie(m.x_offset, m.y_offset, m.height, m.width, m.do_rectify); }
};

struct CameraInfo {
  static constexpr const char* kType = "sensor_msgs/msg/CameraInfo";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x = 0, binning_y = 0;
  RegionOfInterest roi;

  static auto fields(auto& m) {
    return std::tie(m.header, m.height, m.width, m.distortion_model, m.d, m.k, m.r, m.p, m.binning_x,
                    m.binning_y, m.roi);
  }
};

}  // namespace robots
