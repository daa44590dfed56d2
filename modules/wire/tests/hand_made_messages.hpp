#pragma once
/// Messages as bytes, put together by hand from the definitions of ROS and the rules of CDR, without aisle's
/// own code for it: little endian, four bytes of encapsulation, each number aligned to its size.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace aisle {

class HandMade {
 public:
  template <class Number>
  HandMade& number(Number value) {
    while ((bytes_.size() - kEncapsulation) % sizeof value != 0) bytes_ += '\0';
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
    return *this;
  }

  HandMade& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.append(value).append(1, '\0');
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kEncapsulation = 4;
  std::string bytes_{"\x00\x01\x00\x00", kEncapsulation};
};

constexpr const char* kStringType = "std_msgs/msg/String";
constexpr const char* kTwistType = "geometry_msgs/msg/Twist";
constexpr const char* kScanType = "sensor_msgs/msg/LaserScan";
constexpr const char* kImageType = "sensor_msgs/msg/Image";
constexpr const char* kStringDdsType = "std_msgs::msg::dds_::String_";
constexpr const char* kTwistDdsType = "geometry_msgs::msg::dds_::Twist_";
constexpr const char* kScanDdsType = "sensor_msgs::msg::dds_::LaserScan_";
constexpr const char* kImageDdsType = "sensor_msgs::msg::dds_::Image_";

/// As it arrives: RTPS fills messages up to a multiple of four bytes.
inline std::string as_received(std::string message) {
  message.append((4 - message.size() % 4) % 4, '\0');
  return message;
}

inline std::string string_message(const std::string& data) {
  return HandMade().text(data).bytes();
}

inline std::string twist_message(double speed_mps, double turn_rate_rad_s) {
  HandMade made;
  for (const double value : {speed_mps, 0.0, 0.0, 0.0, 0.0, turn_rate_rad_s}) made.number(value);
  return made.bytes();
}

inline HandMade stamped(std::int32_t sec, std::uint32_t nanosec, std::string_view frame) {
  HandMade made;
  made.number(sec).number(nanosec).text(frame);
  return made;
}

/// A full circle of beams, each a millimetre longer than the one before.
inline std::string scan_message(std::uint32_t beams) {
  HandMade made = stamped(7, 500'000'000, "laser");
  for (const float value : {-3.0F, 3.0F, 6.0F / static_cast<float>(beams), 0.0F, 0.1F, 0.05F, 12.0F})
    made.number(value);
  made.number(beams);
  for (std::uint32_t i = 0; i < beams; ++i) made.number(1.0F + 0.001F * static_cast<float>(i));
  made.number(std::uint32_t{0});
  return made.bytes();
}

inline std::string image_message(std::uint32_t width_px, std::uint32_t height_px) {
  HandMade made = stamped(8, 0, "camera");
  made.number(height_px).number(width_px).text("mono8").number(std::uint8_t{0}).number(width_px);
  made.number(width_px * height_px);
  for (std::uint32_t i = 0; i < width_px * height_px; ++i) made.number(static_cast<std::uint8_t>(i % 251));
  return made.bytes();
}

}  // namespace aisle
