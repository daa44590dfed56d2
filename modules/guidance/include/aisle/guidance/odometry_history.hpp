#pragma once

#include <array>
#include <cstddef>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/odometry_correction.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Where the vehicle was in its last cycles, by odometry: what an image shows was seen from where the vehicle
/// was when it was taken, and images come late.
class OdometryHistory {
 public:
  explicit OdometryHistory(const VehicleDescription& vehicle, const Pose2& T_odom_start = {})
      : vehicle_(vehicle) {
    poses_.back().T_odom_vehicle = T_odom_start;
  }

  /// Once a cycle.
  void move(const Observation& observation);

  /// From now on, and for what is remembered after a time, the wheels misreport a front-steered vehicle's
  /// motion so.
  void correct(const OdometryCorrection& error, double from_s);

  const Pose2& T_odom_vehicle() const { return latest().T_odom_vehicle; }
  double stamp_s() const { return latest().stamp_s; }

  /// At a time, between two cycles in proportion; before the oldest cycle that is remembered, as in that one.
  Pose2 T_odom_at(double stamp_s) const;

  /// Cycles between the one whose end is nearest to a time and the last one.
  int cycles_since(double stamp_s) const;

 private:
  struct StampedPose {
    double stamp_s = 0;
    Pose2 T_odom_vehicle;
    OdometryReading reading;
  };
  static constexpr std::size_t kCycles = 64;  ///< more than images may be late

  const StampedPose& latest() const { return ago(0); }
  Pose2 step(const OdometryReading& reading) const;
  /// @param cycles  fewer than are remembered
  const StampedPose& ago(std::size_t cycles) const {
    return poses_[(moves_ + kCycles - 1 - cycles) % kCycles];
  }

  VehicleDescription vehicle_;
  OdometryCorrection error_;
  std::array<StampedPose, kCycles> poses_;
  std::size_t moves_ = 0;
};

}  // namespace aisle
