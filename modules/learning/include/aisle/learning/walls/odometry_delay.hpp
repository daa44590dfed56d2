#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {

/// Estimates by how much the recorded odometry is later (positive) or earlier than its scan, from the log
/// itself: during a turn, the heading relative to the walls must change as the odometry says. Sums are kept
/// for every candidate delay, so the estimate at any scan uses only the scans up to it.
class OdometryDelayEstimator {
 public:
  /// Candidates are -1 .. 3 scan periods in steps of a tenth.
  /// @param guess_s  the delay until enough turning has been seen
  OdometryDelayEstimator(const OdometryTrack& odometry, double scan_period_s, double guess_s = 0);

  /// Adds a scan: its time, the number of odometry samples known by then, and the heading of the walls' frame
  /// in the sensor frame modulo 90 degrees (nullopt if the scan shows no frame).
  void add(double time_s, std::size_t odometry_known, std::optional<double> frame_heading_rad);

  /// The delay [s] with the least disagreement; the guess until enough turning has been seen; 0 if no delay
  /// agrees clearly better than none. (Odometry is interpolated between its samples, which averages its
  /// noise: small delays look slightly better than they are.)
  double delay_s() const;

 private:
  struct Seen {
    double time_s;
    std::optional<double> frame_heading_rad;
  };
  struct Candidate {
    double delay_s;
    double disagreement_rad;
  };
  void compare(const Seen& a, const Seen& b, std::size_t odometry_known);

  const OdometryTrack& odometry_;
  double scan_period_s_;
  double guess_s_;
  std::vector<Seen> recent_;
  std::vector<Candidate> candidates_;
  std::size_t comparisons_ = 0;
};

}  // namespace aisle
