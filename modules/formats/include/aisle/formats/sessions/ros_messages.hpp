#pragma once
/// The standard ROS messages that sessions and bags contain, field by field as in their definitions. Each
/// lists its fields once, in the order of its definition: `fields(message, visit)` calls visit("name", field)
/// for each field. The code that reads and writes the bytes (cdr.hpp) is built on it.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace aisle::ros {

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
  }
  friend bool operator==(const Time&, const Time&) = default;
};

struct Header {
  Time stamp;
  std::string frame_id;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("stamp", self.stamp);
    visit("frame_id", self.frame_id);
  }
  friend bool operator==(const Header&, const Header&) = default;
};

struct String {
  static constexpr const char* kType = "std_msgs/msg/String";
  std::string data;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("data", self.data);
  }
  friend bool operator==(const String&, const String&) = default;
};

struct Bool {
  static constexpr const char* kType = "std_msgs/msg/Bool";
  bool data = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("data", self.data);
  }
  friend bool operator==(const Bool&, const Bool&) = default;
};

struct Image {
  static constexpr const char* kType = "sensor_msgs/msg/Image";
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;  ///< bytes from one row to the next
  std::vector<std::uint8_t> data;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("height", self.height);
    visit("width", self.width);
    visit("encoding", self.encoding);
    visit("is_bigendian", self.is_bigendian);
    visit("step", self.step);
    visit("data", self.data);
  }
  friend bool operator==(const Image&, const Image&) = default;
};

struct CompressedImage {
  static constexpr const char* kType = "sensor_msgs/msg/CompressedImage";
  Header header;
  std::string format;  ///< "jpeg" or "png"
  std::vector<std::uint8_t> data;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("format", self.format);
    visit("data", self.data);
  }
  friend bool operator==(const CompressedImage&, const CompressedImage&) = default;
};

struct RegionOfInterest {
  std::uint32_t x_offset = 0;
  std::uint32_t y_offset = 0;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  bool do_rectify = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("x_offset", self.x_offset);
    visit("y_offset", self.y_offset);
    visit("height", self.height);
    visit("width", self.width);
    visit("do_rectify", self.do_rectify);
  }
  friend bool operator==(const RegionOfInterest&, const RegionOfInterest&) = default;
};

struct CameraInfo {
  static constexpr const char* kType = "sensor_msgs/msg/CameraInfo";
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{};
  std::array<double, 9> r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  RegionOfInterest roi;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("height", self.height);
    visit("width", self.width);
    visit("distortion_model", self.distortion_model);
    visit("d", self.d);
    visit("k", self.k);
    visit("r", self.r);
    visit("p", self.p);
    visit("binning_x", self.binning_x);
    visit("binning_y", self.binning_y);
    visit("roi", self.roi);
  }
  friend bool operator==(const CameraInfo&, const CameraInfo&) = default;
};

struct LaserScan {
  static constexpr const char* kType = "sensor_msgs/msg/LaserScan";
  Header header;
  float angle_min = 0;
  float angle_max = 0;
  float angle_increment = 0;
  float time_increment = 0;
  float scan_time = 0;
  float range_min = 0;
  float range_max = 0;
  std::vector<float> ranges;
  std::vector<float> intensities;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("angle_min", self.angle_min);
    visit("angle_max", self.angle_max);
    visit("angle_increment", self.angle_increment);
    visit("time_increment", self.time_increment);
    visit("scan_time", self.scan_time);
    visit("range_min", self.range_min);
    visit("range_max", self.range_max);
    visit("ranges", self.ranges);
    visit("intensities", self.intensities);
  }
  friend bool operator==(const LaserScan&, const LaserScan&) = default;
};

struct JointState {
  static constexpr const char* kType = "sensor_msgs/msg/JointState";
  Header header;
  std::vector<std::string> name;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> effort;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("name", self.name);
    visit("position", self.position);
    visit("velocity", self.velocity);
    visit("effort", self.effort);
  }
  friend bool operator==(const JointState&, const JointState&) = default;
};

/// geometry_msgs/Vector3 and geometry_msgs/Point: both have the same bytes.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
  }
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
    visit("w", self.w);
  }
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

struct Pose {
  static constexpr const char* kType = "geometry_msgs/msg/Pose";
  Vector3 position;
  Quaternion orientation;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("position", self.position);
    visit("orientation", self.orientation);
  }
  friend bool operator==(const Pose&, const Pose&) = default;
};

struct PoseStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseStamped";
  Header header;
  Pose pose;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("pose", self.pose);
  }
  friend bool operator==(const PoseStamped&, const PoseStamped&) = default;
};

struct Twist {
  static constexpr const char* kType = "geometry_msgs/msg/Twist";
  Vector3 linear;
  Vector3 angular;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("linear", self.linear);
    visit("angular", self.angular);
  }
  friend bool operator==(const Twist&, const Twist&) = default;
};

struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TwistStamped";
  Header header;
  Twist twist;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("twist", self.twist);
  }
  friend bool operator==(const TwistStamped&, const TwistStamped&) = default;
};

struct AckermannDrive {
  float steering_angle = 0;  ///< [rad] left positive, of a wheel in the middle of the front axle
  float steering_angle_velocity = 0;
  float speed = 0;  ///< [m/s] of the middle of the rear axle
  float acceleration = 0;
  float jerk = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("steering_angle", self.steering_angle);
    visit("steering_angle_velocity", self.steering_angle_velocity);
    visit("speed", self.speed);
    visit("acceleration", self.acceleration);
    visit("jerk", self.jerk);
  }
  friend bool operator==(const AckermannDrive&, const AckermannDrive&) = default;
};

struct AckermannDriveStamped {
  static constexpr const char* kType = "ackermann_msgs/msg/AckermannDriveStamped";
  Header header;
  AckermannDrive drive;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("drive", self.drive);
  }
  friend bool operator==(const AckermannDriveStamped&, const AckermannDriveStamped&) = default;
};

struct Joy {
  static constexpr const char* kType = "sensor_msgs/msg/Joy";
  Header header;
  std::vector<float> axes;  ///< -1 to 1; left and ahead are positive
  std::vector<std::int32_t> buttons;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("axes", self.axes);
    visit("buttons", self.buttons);
  }
  friend bool operator==(const Joy&, const Joy&) = default;
};

struct BatteryState {
  static constexpr const char* kType = "sensor_msgs/msg/BatteryState";
  Header header;
  float voltage = 0;
  float temperature = 0;
  float current = 0;
  float charge = 0;
  float capacity = 0;
  float design_capacity = 0;
  float percentage = 0;  ///< of the full charge, 0 to 1; NaN: unknown
  std::uint8_t power_supply_status = 0;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = false;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("voltage", self.voltage);
    visit("temperature", self.temperature);
    visit("current", self.current);
    visit("charge", self.charge);
    visit("capacity", self.capacity);
    visit("design_capacity", self.design_capacity);
    visit("percentage", self.percentage);
    visit("power_supply_status", self.power_supply_status);
    visit("power_supply_health", self.power_supply_health);
    visit("power_supply_technology", self.power_supply_technology);
    visit("present", self.present);
    visit("cell_voltage", self.cell_voltage);
    visit("cell_temperature", self.cell_temperature);
    visit("location", self.location);
    visit("serial_number", self.serial_number);
  }
  friend bool operator==(const BatteryState&, const BatteryState&) = default;
};

struct Clock {
  static constexpr const char* kType = "rosgraph_msgs/msg/Clock";
  Time clock;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("clock", self.clock);
  }
  friend bool operator==(const Clock&, const Clock&) = default;
};

struct PoseWithCovariance {
  Pose pose;
  std::array<double, 36> covariance{};

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("pose", self.pose);
    visit("covariance", self.covariance);
  }
  friend bool operator==(const PoseWithCovariance&, const PoseWithCovariance&) = default;
};

struct TwistWithCovariance {
  Twist twist;
  std::array<double, 36> covariance{};

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("twist", self.twist);
    visit("covariance", self.covariance);
  }
  friend bool operator==(const TwistWithCovariance&, const TwistWithCovariance&) = default;
};

struct Odometry {
  static constexpr const char* kType = "nav_msgs/msg/Odometry";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("pose", self.pose);
    visit("twist", self.twist);
  }
  friend bool operator==(const Odometry&, const Odometry&) = default;
};

struct Transform {
  Vector3 translation;
  Quaternion rotation;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("translation", self.translation);
    visit("rotation", self.rotation);
  }
  friend bool operator==(const Transform&, const Transform&) = default;
};

struct TransformStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TransformStamped";
  Header header;
  std::string child_frame_id;
  Transform transform;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("transform", self.transform);
  }
  friend bool operator==(const TransformStamped&, const TransformStamped&) = default;
};

struct TFMessage {
  static constexpr const char* kType = "tf2_msgs/msg/TFMessage";
  std::vector<TransformStamped> transforms;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("transforms", self.transforms);
  }
  friend bool operator==(const TFMessage&, const TFMessage&) = default;
};

struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovarianceStamped";
  Header header;
  PoseWithCovariance pose;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("pose", self.pose);
  }
  friend bool operator==(const PoseWithCovarianceStamped&, const PoseWithCovarianceStamped&) = default;
};

struct Path {
  static constexpr const char* kType = "nav_msgs/msg/Path";
  Header header;
  std::vector<PoseStamped> poses;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("poses", self.poses);
  }
  friend bool operator==(const Path&, const Path&) = default;
};

struct MapMetaData {
  Time map_load_time;
  float resolution = 0;  ///< side of a cell [m]
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Pose origin;  ///< of the lower left corner of cell (0, 0)

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("map_load_time", self.map_load_time);
    visit("resolution", self.resolution);
    visit("width", self.width);
    visit("height", self.height);
    visit("origin", self.origin);
  }
  friend bool operator==(const MapMetaData&, const MapMetaData&) = default;
};

struct OccupancyGrid {
  static constexpr const char* kType = "nav_msgs/msg/OccupancyGrid";
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;  ///< row by row from the bottom: 0 free, 100 occupied, -1 unknown

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("info", self.info);
    visit("data", self.data);
  }
  friend bool operator==(const OccupancyGrid&, const OccupancyGrid&) = default;
};

struct ColorRGBA {
  float r = 0;
  float g = 0;
  float b = 0;
  float a = 1;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("r", self.r);
    visit("g", self.g);
    visit("b", self.b);
    visit("a", self.a);
  }
  friend bool operator==(const ColorRGBA&, const ColorRGBA&) = default;
};

struct Duration {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
  }
  friend bool operator==(const Duration&, const Duration&) = default;
};

struct UVCoordinate {
  float u = 0;
  float v = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("u", self.u);
    visit("v", self.v);
  }
  friend bool operator==(const UVCoordinate&, const UVCoordinate&) = default;
};

struct MeshFile {
  std::string filename;
  std::vector<std::uint8_t> data;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("filename", self.filename);
    visit("data", self.data);
  }
  friend bool operator==(const MeshFile&, const MeshFile&) = default;
};

struct Marker {
  enum Kind : std::int32_t { kSphereList = 7, kLineStrip = 4, kLineList = 5, kText = 9 };
  static constexpr const char* kType = "visualization_msgs/msg/Marker";
  Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = 0;
  Pose pose;
  Vector3 scale;
  ColorRGBA color;
  Duration lifetime;
  bool frame_locked = false;
  std::vector<Vector3> points;
  std::vector<ColorRGBA> colors;
  std::string texture_resource;
  CompressedImage texture;
  std::vector<UVCoordinate> uv_coordinates;
  std::string text;
  std::string mesh_resource;
  MeshFile mesh_file;
  bool mesh_use_embedded_materials = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("ns", self.ns);
    visit("id", self.id);
    visit("type", self.type);
    visit("action", self.action);
    visit("pose", self.pose);
    visit("scale", self.scale);
    visit("color", self.color);
    visit("lifetime", self.lifetime);
    visit("frame_locked", self.frame_locked);
    visit("points", self.points);
    visit("colors", self.colors);
    visit("texture_resource", self.texture_resource);
    visit("texture", self.texture);
    visit("uv_coordinates", self.uv_coordinates);
    visit("text", self.text);
    visit("mesh_resource", self.mesh_resource);
    visit("mesh_file", self.mesh_file);
    visit("mesh_use_embedded_materials", self.mesh_use_embedded_materials);
  }
  friend bool operator==(const Marker&, const Marker&) = default;
};

struct MarkerArray {
  static constexpr const char* kType = "visualization_msgs/msg/MarkerArray";
  std::vector<Marker> markers;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("markers", self.markers);
  }
  friend bool operator==(const MarkerArray&, const MarkerArray&) = default;
};

}  // namespace aisle::ros
