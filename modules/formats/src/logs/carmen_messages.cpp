#include "logs/carmen_messages.hpp"

#include <algorithm>
#include <array>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMaxBeams = 10000;
constexpr double kRangeLimit_m = 1e6;
constexpr double kStampLimit_s = 1e11;
constexpr double kSkippedNumberMax = 1e30;

void read_ranges(FieldReader& fields, double metres_per_unit, std::vector<float>& ranges_m) {
  const std::size_t count = fields.count("number of readings", 2, kMaxBeams);
  ranges_m.reserve(count);
  for (std::size_t i = 0; i < count && fields.ok(); ++i) {
    ranges_m.push_back(static_cast<float>(fields.distance("reading", kRangeLimit_m) * metres_per_unit));
  }
}

void skip_numbers(FieldReader& fields, std::size_t count, const char* what) {
  for (std::size_t i = 0; i < count && fields.ok(); ++i) fields.number(what, kSkippedNumberMax);
}

StampFields read_stamp(FieldReader& fields) {
  StampFields stamp;
  stamp.stamp_s = fields.number("ipc timestamp", kStampLimit_s);
  stamp.after_stamp = fields.remaining(2);
  return stamp;
}

/// The fields with which RAWLASER1 and ROBOTLASER1 begin: laser_type start_angle field_of_view
/// angular_resolution maximum_range accuracy remission_mode num_readings [readings] num_remissions
/// [remissions]
ScanMessage read_laser_head(FieldReader& fields, double metres_per_unit) {
  ScanMessage scan;
  skip_numbers(fields, 1, "laser type");
  BeamAngles angles;
  angles.first_angle_rad = fields.number("start angle", 2 * kPi);
  const double field_of_view_rad = fields.number("field of view", 2.1 * kPi);
  angles.angle_step_rad = fields.number("angular resolution", kPi);
  scan.maximum_range_m = fields.distance("maximum range", kRangeLimit_m) * metres_per_unit;
  skip_numbers(fields, 2, "accuracy or remission mode");
  read_ranges(fields, metres_per_unit, scan.ranges_m);
  if (!fields.ok()) return scan;
  const auto steps = static_cast<double>(scan.ranges_m.size() - 1);
  if (angles.angle_step_rad == 0) angles.angle_step_rad = field_of_view_rad / steps;
  if (angles.angle_step_rad <= 0 || angles.angle_step_rad * steps > 2.1 * kPi) {
    fields.fail("the angular resolution does not fit the number of readings");
  }
  scan.angles = angles;
  skip_numbers(fields, fields.count("number of remissions", 0, kMaxBeams), "remission");
  return scan;
}

}  // namespace

std::optional<Pose2> CarmenParams::mounting() const {
  if (!offset_m && !side_offset_m && !angular_offset_rad) return std::nullopt;
  return Pose2{offset_m.value_or(0), side_offset_m.value_or(0), angular_offset_rad.value_or(0)};
}

/// num_readings [readings] laser_pose robot_pose ipc_timestamp host logger_timestamp
ScanMessage read_flaser(FieldReader& fields, double metres_per_unit) {
  ScanMessage scan;
  read_ranges(fields, metres_per_unit, scan.ranges_m);
  scan.T_odom_laser = fields.pose("laser pose", metres_per_unit);
  scan.T_odom_vehicle = fields.pose("robot pose", metres_per_unit);
  scan.stamp = read_stamp(fields);
  return scan;
}

/// head, ipc_timestamp host logger_timestamp
ScanMessage read_rawlaser(FieldReader& fields, double metres_per_unit) {
  ScanMessage scan = read_laser_head(fields, metres_per_unit);
  scan.stamp = read_stamp(fields);
  return scan;
}

/// head, laser_pose robot_pose tv rv forward_safety side_safety turn_axis ipc_timestamp host logger_timestamp
ScanMessage read_robotlaser(FieldReader& fields, double metres_per_unit) {
  ScanMessage scan = read_laser_head(fields, metres_per_unit);
  scan.T_odom_laser = fields.pose("laser pose", metres_per_unit);
  scan.T_odom_vehicle = fields.pose("robot pose", metres_per_unit);
  skip_numbers(fields, 5, "velocity, safety distance or turn axis");
  scan.stamp = read_stamp(fields);
  return scan;
}

/// x y theta tv rv accel ipc_timestamp host logger_timestamp
OdometryMessage read_odometry(FieldReader& fields, double metres_per_unit) {
  OdometryMessage odometry;
  odometry.T_odom_vehicle = fields.pose("robot pose", metres_per_unit);
  skip_numbers(fields, 3, "velocity or acceleration");
  odometry.stamp = read_stamp(fields);
  return odometry;
}

/// name value ipc_timestamp host logger_timestamp
void read_param(FieldReader& fields, double metres_per_unit, CarmenParams& params) {
  const std::string_view name = fields.word();
  if (name == "robot_frontlaser_offset") {
    params.offset_m = fields.number("offset", kRangeLimit_m) * metres_per_unit;
  } else if (name == "robot_frontlaser_side_offset") {
    params.side_offset_m = fields.number("side offset", kRangeLimit_m) * metres_per_unit;
  } else if (name == "robot_frontlaser_angular_offset") {
    params.angular_offset_rad = fields.number("angular offset", 2 * kPi);
  } else if (name == "robot_front_laser_max" || name == "laser_front_laser_max") {
    params.maximum_range_m = fields.distance("maximum range", kRangeLimit_m) * metres_per_unit;
  } else if (name == "laser_front_laser_resolution") {
    params.resolution_deg = fields.number("resolution", 90);
    if (fields.ok() && *params.resolution_deg <= 0) fields.fail("the resolution is not positive");
  }
}

bool is_other_carmen_message(std::string_view name) {
  constexpr std::array<std::string_view, 30> kBeginnings = {
      "ARM",       "BASEVELOCITY", "BUMPER",        "CAMERA",          "COMMENT",   "FOLLOWTRAJECTORY",
      "GLOBALPOS", "GPS",          "IMU",           "LASER",           "LOCALIZE",  "MARKER",
      "NMEA",      "ODOM_",        "PANTILT",       "POSITION",        "RAWLASER",  "REMISSION",
      "RLASER",    "ROBOTLASER",   "ROBOTVELOCITY", "SCANMARK",        "SCANMATCH", "SONAR",
      "SYNC",      "TRUEPOS",      "VECTORMOVE",    "VISUAL_ODOMETRY", "WIFI",      "XSENS"};
  return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                     [&](std::string_view beginning) { return name.starts_with(beginning); });
}

}  // namespace aisle
