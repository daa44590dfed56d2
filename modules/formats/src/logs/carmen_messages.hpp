#pragma once
/// Single messages (lines) of a CARMEN log. The readers take the fields after the message's name; failures
/// stay in `fields`. Lengths are converted to metres.

#include <optional>
#include <string_view>
#include <vector>

#include "aisle/vehicle/laser_log.hpp"
#include "field_reader.hpp"

namespace aisle {

struct StampFields {
  double stamp_s = 0;           ///< ipc_timestamp
  std::size_t after_stamp = 0;  ///< how many of host and logger_timestamp follow
};

struct ScanMessage {
  std::vector<double> readings_m;     ///< as recorded: any of them may be NaN, infinite or negative
  std::optional<ScanBeams> beams;     ///< absent if the message does not give them (FLASER); may be clockwise
  bool fits_field_of_view = true;     ///< false: the angular resolution did not, and is not used
  double maximum_range_m = 0;         ///< 0: not given
  std::optional<Pose2> T_odom_laser;  ///< absent if the message has no poses (RAWLASER1)
  std::optional<Pose2> T_odom_vehicle;
  StampFields stamp;
};

struct OdometryMessage {
  Pose2 T_odom_vehicle;
  StampFields stamp;
};

/// What PARAM lines say about the front scanner.
struct CarmenParams {
  std::optional<double> offset_m, side_offset_m, angular_offset_rad;
  std::optional<double> maximum_range_m;
  std::optional<double> resolution_deg;

  /// T_vehicle_laser, if any PARAM line gives it.
  std::optional<Pose2> mounting() const;
};

ScanMessage read_flaser(FieldReader& fields, double metres_per_unit);
ScanMessage read_rawlaser(FieldReader& fields, double metres_per_unit);
ScanMessage read_robotlaser(FieldReader& fields, double metres_per_unit);
OdometryMessage read_odometry(FieldReader& fields, double metres_per_unit);
void read_param(FieldReader& fields, double metres_per_unit, CarmenParams& params);

/// Whether this is a message of CARMEN or its relatives that says nothing about the front scanner.
bool is_other_carmen_message(std::string_view name);

}  // namespace aisle
