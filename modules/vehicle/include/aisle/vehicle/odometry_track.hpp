#pragma once

#include <span>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Odometry as a function of time.
class OdometryTrack {
 public:
  /// The samples must be in order of time, not empty, and outlive the track.
  explicit OdometryTrack(std::span<const OdometrySample> samples) : samples_(samples) {}

  /// Pose of the vehicle in `odom` at a time, interpolated among the first `known` samples (at least 1).
  /// After the last of them the last motion is carried on for at most half a second; before the first, the
  /// vehicle stands.
  Pose2 at(double time_s, std::size_t known) const;

 private:
  std::span<const OdometrySample> samples_;
};

}  // namespace aisle
