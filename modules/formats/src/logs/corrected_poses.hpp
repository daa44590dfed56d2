#pragma once

#include <optional>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Tells whether the poses in the scans of a log are odometry, as its ODOM lines are, or were corrected by a
/// mapping program: then their motion differs from the wheels', by more than the two lines are apart.
class CorrectedPoses {
 public:
  /// @param T_odom  of the latest ODOM line
  /// @param T_scan  of the scan's own line
  void add(const Pose2& T_odom, const Pose2& T_scan, long line);

  /// The line of the first motion that differs; none if the poses are odometry.
  std::optional<long> first_line() const;

 private:
  struct Pair {
    Pose2 T_odom, T_scan;
  };
  std::optional<Pair> first_, latest_;
  int same_ = 0, different_ = 0;
  long first_line_ = 0;
};

}  // namespace aisle
