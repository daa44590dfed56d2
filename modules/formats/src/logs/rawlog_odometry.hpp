#pragma once

#include <cstddef>

#include "aisle/vehicle/laser_log.hpp"
#include "logs/mrpt_objects.hpp"

namespace aisle {

/// The odometry of a rawlog: poses that were observed or, in logs of actions and frames, the sum of the
/// movements between frames, at the time of the frame's scan. What comes first counts, the other repeats it.
class RawlogOdometry {
 public:
  explicit RawlogOdometry(LaserLog& log) : log_(log) {}

  void add(const MrptOdometry& odometry, long object);
  /// A collection of movements begins: all of them tell of the same motion.
  void begin_collection();
  void add(const MrptMovement& movement);
  /// Call before each scan.
  void reach_scan(double stamp_s, long object);
  /// A first frame may come before the first movement.
  void finish();

 private:
  enum class Kind { kUnknown, kPoses, kMovements };

  LaserLog& log_;
  Kind kind_ = Kind::kUnknown;
  Pose2 T_odom_vehicle_, T_odom_before_;
  bool has_movement_ = false, by_odometry_ = false, is_pending_ = false;
};

}  // namespace aisle
