#pragma once
/// Small rawlogs for tests, written as MRPT's versions wrote them.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

template <class Value>
std::string mrpt_value(Value value) {
  std::string bytes(sizeof(Value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Value));
  return bytes;
}

inline std::string mrpt_text(std::string_view text) {
  return mrpt_value(static_cast<std::uint32_t>(text.size())) + std::string(text);
}

inline std::string mrpt_object(std::string_view class_name, int version, const std::string& contents) {
  return std::string(1, static_cast<char>(0x80U | class_name.size())) + std::string(class_name) +
         static_cast<char>(version) + contents + '\x88';
}

/// Ticks of 100 ns since 1601.
inline std::string mrpt_stamp(double seconds_since_1970) {
  return mrpt_value(static_cast<std::uint64_t>((seconds_since_1970 + 11644473600.0) * 1e7 + 0.5));
}

inline std::string mrpt_pose2(const Pose2& pose, const std::string& space = "mrpt::poses::") {
  return mrpt_object(space + "CPose2D", 1, mrpt_value(pose.x) + mrpt_value(pose.y) + mrpt_value(pose.theta));
}

/// Version 3 of CPose3D; `up` is 1 upright, -1 upside down about the x axis, 0 on its side.
inline std::string mrpt_pose3(const Pose2& pose, double up = 1) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta), side = up == 0 ? 1 : 0;
  std::string bytes;
  for (const double value :
       {pose.x, pose.y, 0.3, c, -s * up, s * side, s, c * up, -c * side, 0.0, side, up}) {
    bytes += mrpt_value(value);
  }
  return mrpt_object("mrpt::poses::CPose3D", 3, bytes);
}

struct MrptScanBytes {
  int version = 7;
  double aperture_rad = 2;
  bool counter_clockwise = true;
  double range_max_m = 10;
  std::string pose = mrpt_pose3({});
  std::vector<float> readings_m = {1, 2, 3};
  std::string valid = std::string(3, '\1');
  double stamp_s = 1000;
  std::string label = "LASER";
  std::string space = "mrpt::obs::";
};

inline std::string mrpt_scan(const MrptScanBytes& scan) {
  std::string bytes = mrpt_value(static_cast<float>(scan.aperture_rad)) +
                      (scan.counter_clockwise ? '\1' : '\0') +
                      mrpt_value(static_cast<float>(scan.range_max_m)) + scan.pose;
  if (scan.version < 6) {
    bytes += mrpt_object("CMatrix", 0,
                         mrpt_value(std::uint32_t{1}) + mrpt_value(std::uint32_t{1}) + mrpt_value(0.F));
  }
  bytes += mrpt_value(static_cast<std::uint32_t>(scan.readings_m.size()));
  for (const float reading_m : scan.readings_m) bytes += mrpt_value(reading_m);
  if (scan.version >= 1) bytes += scan.valid;
  if (scan.version >= 2) bytes += mrpt_value(0.01F);
  if (scan.version >= 3) bytes += mrpt_stamp(scan.stamp_s);
  if (scan.version >= 4) bytes += mrpt_value(0.004F);
  if (scan.version >= 5) bytes += mrpt_text(scan.label) + mrpt_value(0.0);
  if (scan.version >= 7) bytes += '\0';
  return mrpt_object(scan.space + "CObservation2DRangeScan", scan.version, bytes);
}

inline std::string mrpt_odometry(const Pose2& pose, double stamp_s) {
  return mrpt_object("mrpt::obs::CObservationOdometry", 2,
                     mrpt_pose2(pose) + mrpt_text("ODOMETRY") + mrpt_stamp(stamp_s) + '\0' + '\0');
}

/// A collection with one movement by odometry, as version 6 or 7.
inline std::string mrpt_action(const Pose2& motion, int version = 6) {
  std::string bytes = mrpt_value(std::uint32_t{0}) + mrpt_pose2(motion, "") + std::string(14 * 4, '\0');
  bytes += version >= 7 ? std::string(2, '\0') : std::string(1 + 8 + 1 + 8, '\0');
  bytes += mrpt_stamp(5);
  return mrpt_object("CActionCollection", 0,
                     mrpt_value(std::uint32_t{1}) + mrpt_object("CActionRobotMovement2D", version, bytes));
}

inline std::string mrpt_frame(const std::string& observations, std::uint32_t count = 1) {
  return mrpt_object("CSensoryFrame", 2, mrpt_value(count) + observations);
}

}  // namespace aisle
