#pragma once
/// The objects of a rawlog that tell of a scanner and its vehicle, in all versions. Each reader takes what
/// follows the object's header, with its end; failures stay in the stream.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "logs/mrpt_stream.hpp"

namespace aisle {

/// A pose in space, as far as a flat world needs it.
struct SensorPose {
  Pose2 flat;
  double up_z = 1;  ///< z component of the sensor's own z axis: 1 upright, -1 upside down
};

struct MrptScan {
  double aperture_rad = 0;  ///< from the first beam to the last, symmetric about straight ahead
  bool counter_clockwise = true;
  double range_max_m = 0;
  SensorPose T_vehicle_laser;
  std::vector<float> readings_m;
  std::string_view valid;  ///< one character a reading; 0: it is none
  double stamp_s = 0;      ///< 0: none
  std::string label;
};

struct MrptOdometry {
  Pose2 T_odom_vehicle;
  double stamp_s = 0;
};

/// The motion since the action before.
struct MrptMovement {
  Pose2 motion;
  bool by_odometry = true;  ///< false: from matching scans
};

MrptScan read_mrpt_scan(MrptStream& stream, int version);
MrptOdometry read_mrpt_odometry(MrptStream& stream, int version);
MrptMovement read_mrpt_movement(MrptStream& stream, int version);

}  // namespace aisle
