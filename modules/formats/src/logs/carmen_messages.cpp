#include "logs/carmen_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMaxBeams = 10000;
constexpr double kRangeLimit_m = 1e6;
constexpr double kStampLimit_s = 1e11;
constexpr double kCircle_rad = 2.1 * kPi;
constexpr double kSkippedNumberMax = 1e30;

void read_readings(FieldReader& fields, double metres_per_unit, std::vector<double>& readings_m) {
  const std::size_t count = fields.count("number of readings", 2, kMaxBeams);
  readings_m.reserve(count);
  for (std::size_t i = 0; i < count && fields.ok(); ++i) {
    readings_m.push_back(fields.any_number("reading") * metres_per_unit);
  }
}

/// Where the angular resolution, often rounded, disagrees with the field of view by more than a step, takes
/// the field of view's; not where the scan would then be less symmetric about straight ahead than without.
/// Of a full circle, the last gap is that between the last reading and the first.
/// @return false if it did
bool settle_step(ScanBeams& beams, double field_of_view_rad, double steps) {
  const bool is_full_circle = std::abs(field_of_view_rad - 2 * kPi) < kPi / steps;
  const double by_field_of_view_rad = is_full_circle ? 2 * kPi / (steps + 1) : field_of_view_rad / steps;
  if (beams.angle_step_rad == 0) {
    beams.angle_step_rad = by_field_of_view_rad;
    return true;
  }
  if (field_of_view_rad == 0) return true;
  const double signed_step_rad = std::copysign(by_field_of_view_rad, beams.angle_step_rad);
  const auto asymmetry_rad = [&](double step_rad) {
    return std::abs(2 * beams.first_angle_rad + step_rad * steps);
  };
  const double disagreement_rad = std::abs(beams.angle_step_rad - signed_step_rad) * steps;
  // One step too many is the convention of those who count readings instead of the gaps between them.
  if (disagreement_rad < 1.5 * std::abs(beams.angle_step_rad)) return true;
  if (asymmetry_rad(signed_step_rad) > asymmetry_rad(beams.angle_step_rad)) return true;
  beams.angle_step_rad = signed_step_rad;
  return false;
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
  ScanBeams beams;
  beams.first_angle_rad = fields.number("start angle", kCircle_rad);
  const double field_of_view_rad = fields.number("field of view", kCircle_rad);
  beams.angle_step_rad = fields.number("angular resolution", kPi);
  scan.maximum_range_m = fields.distance("maximum range", kRangeLimit_m) * metres_per_unit;
  skip_numbers(fields, 2, "accuracy or remission mode");
  read_readings(fields, metres_per_unit, scan.readings_m);
  if (!fields.ok()) return scan;
  const auto steps = static_cast<double>(scan.readings_m.size() - 1);
  scan.fits_field_of_view = settle_step(beams, field_of_view_rad, steps);
  if (beams.angle_step_rad == 0 || std::abs(beams.angle_step_rad) * steps > kCircle_rad) {
    fields.fail("the angular resolution does not fit the number of readings");
  }
  scan.beams = beams;
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
  read_readings(fields, metres_per_unit, scan.readings_m);
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
  CarmenParams read = params;
  if (name == "robot_frontlaser_offset") {
    read.offset_m = fields.number("offset", kRangeLimit_m) * metres_per_unit;
  } else if (name == "robot_frontlaser_side_offset") {
    read.side_offset_m = fields.number("side offset", kRangeLimit_m) * metres_per_unit;
  } else if (name == "robot_frontlaser_angular_offset") {
    read.angular_offset_rad = fields.number("angular offset", 2 * kPi);
  } else if (name == "robot_front_laser_max" || name == "laser_front_laser_max") {
    read.maximum_range_m = fields.distance("maximum range", kRangeLimit_m) * metres_per_unit;
  } else if (name == "laser_front_laser_resolution") {
    read.resolution_deg = fields.number("resolution", 90);
    if (fields.ok() && *read.resolution_deg <= 0) fields.fail("the resolution is not positive");
  }
  if (fields.ok()) params = read;  // a line that is left out says nothing
}

bool is_other_carmen_message(std::string_view name) {
  constexpr std::array<std::string_view, 31> kBeginnings = {
      "ARM",       "BASEVELOCITY", "BUMPER",     "CAMERA",        "COMMENT",         "FOLLOWTRAJECTORY",
      "GLOBALPOS", "GPS",          "IMU",        "LASER",         "LOCALIZE",        "MARKER",
      "NEFF",      "NMEA",         "ODOM_",      "PANTILT",       "POSITION",        "RAWLASER",
      "REMISSION", "RLASER",       "ROBOTLASER", "ROBOTVELOCITY", "SCANMARK",        "SCANMATCH",
      "SONAR",     "SYNC",         "TRUEPOS",    "VECTORMOVE",    "VISUAL_ODOMETRY", "WIFI",
      "XSENS"};
  return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                     [&](std::string_view beginning) { return name.starts_with(beginning); });
}

}  // namespace aisle
