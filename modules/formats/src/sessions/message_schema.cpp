#include "aisle/formats/sessions/message_schema.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle {
namespace {

/// The name of a field's type in a message definition.
template <class Field>
struct SchemaName;

#define AISLE_SCHEMA_NAME(Field, name)         \
  template <>                                  \
  struct SchemaName<Field> {                   \
    static std::string text() { return name; } \
  };

AISLE_SCHEMA_NAME(bool, "bool")
AISLE_SCHEMA_NAME(std::int8_t, "int8")
AISLE_SCHEMA_NAME(std::uint8_t, "uint8")
AISLE_SCHEMA_NAME(std::int32_t, "int32")
AISLE_SCHEMA_NAME(std::uint32_t, "uint32")
AISLE_SCHEMA_NAME(float, "float32")
AISLE_SCHEMA_NAME(double, "float64")
AISLE_SCHEMA_NAME(std::string, "string")
AISLE_SCHEMA_NAME(ros::Time, "builtin_interfaces/Time")
AISLE_SCHEMA_NAME(ros::Duration, "builtin_interfaces/Duration")
AISLE_SCHEMA_NAME(ros::Header, "std_msgs/Header")
AISLE_SCHEMA_NAME(ros::ColorRGBA, "std_msgs/ColorRGBA")
AISLE_SCHEMA_NAME(ros::RegionOfInterest, "sensor_msgs/RegionOfInterest")
AISLE_SCHEMA_NAME(ros::Vector3, "geometry_msgs/Vector3")
AISLE_SCHEMA_NAME(ros::Quaternion, "geometry_msgs/Quaternion")
AISLE_SCHEMA_NAME(ros::Pose, "geometry_msgs/Pose")
AISLE_SCHEMA_NAME(ros::PoseWithCovariance, "geometry_msgs/PoseWithCovariance")
AISLE_SCHEMA_NAME(ros::TwistWithCovariance, "geometry_msgs/TwistWithCovariance")
AISLE_SCHEMA_NAME(ros::Transform, "geometry_msgs/Transform")
AISLE_SCHEMA_NAME(ros::TransformStamped, "geometry_msgs/TransformStamped")
AISLE_SCHEMA_NAME(ros::MapMetaData, "nav_msgs/MapMetaData")
AISLE_SCHEMA_NAME(ros::UVCoordinate, "visualization_msgs/UVCoordinate")
AISLE_SCHEMA_NAME(ros::MeshFile, "visualization_msgs/MeshFile")

#undef AISLE_SCHEMA_NAME

template <class Message>
requires requires {
  Message::kType;
}
struct SchemaName<Message> {
  static std::string text() {
    std::string name = Message::kType;
    return name.erase(name.find("/msg"), std::char_traits<char>::length("/msg"));
  }
};

template <class Element>
struct SchemaName<std::vector<Element>> {
  static std::string text() { return SchemaName<Element>::text() + "[]"; }
};

template <class Element, std::size_t count>
struct SchemaName<std::array<Element, count>> {
  static std::string text() { return SchemaName<Element>::text() + "[" + std::to_string(count) + "]"; }
};

template <class Field>
concept DefinedByFields = requires(Field& field) {
  Field::fields(field, [](const char*, auto&) {});
};

/// The definitions of a message and of all types within it, each once, in the order of first use.
class SchemaText {
 public:
  template <DefinedByFields Message>
  void define(const Message& message) {
    const std::string name = SchemaName<Message>::text();
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    names_.push_back(name);
    if (!text_.empty()) text_ += std::string(80, '=') + "\nMSG: " + name + "\n";
    Message::fields(message, [this](const char* field_name, const auto& field) {
      text_ += SchemaName<std::remove_cvref_t<decltype(field)>>::text() + " " + field_name + "\n";
    });
    Message::fields(message, [this](const char*, const auto& field) { define_within(field); });
  }

  std::string text() && { return std::move(text_); }

 private:
  template <class Field>
  void define_within(const Field& /*field*/) {}
  template <DefinedByFields Field>
  void define_within(const Field& field) {
    define(field);
  }
  template <DefinedByFields Element>
  void define_within(const std::vector<Element>& /*elements*/) {
    define(Element{});
  }

  std::vector<std::string> names_;
  std::string text_;
};

template <class... Messages>
std::map<std::string, std::string, std::less<>> schemas_of() {
  const auto schema = [](const auto& message) {
    SchemaText text;
    text.define(message);
    return std::move(text).text();
  };
  return {{Messages::kType, schema(Messages{})}...};
}

}  // namespace

std::string message_schema(std::string_view type) {
  static const auto schemas =
      schemas_of<ros::String, ros::Bool, ros::Image, ros::CompressedImage, ros::CameraInfo, ros::LaserScan,
                 ros::JointState, ros::PoseStamped, ros::Twist, ros::Odometry, ros::TFMessage,
                 ros::PoseWithCovarianceStamped, ros::Path, ros::OccupancyGrid, ros::Marker,
                 ros::MarkerArray>();
  const auto found = schemas.find(type);
  if (found == schemas.end()) throw std::invalid_argument("no message is of type " + std::string(type));
  return found->second;
}

}  // namespace aisle
