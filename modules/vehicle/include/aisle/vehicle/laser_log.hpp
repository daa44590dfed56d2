#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How a 2-D laser scanner sits on the vehicle and what its readings mean.
struct LaserScanner {
  double first_angle_rad = 0;  ///< beam 0 in the laser's frame; 0 is straight ahead
  double angle_step_rad = 0;   ///< from one beam to the next, counter-clockwise
  double range_max_m = 0;      ///< a reading of this or more means "nothing seen"
  Pose2 T_vehicle_laser;

  double beam_angle(std::size_t beam) const {
    return first_angle_rad + angle_step_rad * static_cast<double>(beam);
  }

  void describe(FieldList& fields);
};

/// The half circle ahead in steps of a degree, up to 30 m.
inline constexpr LaserScanner kOneReadingADegree{-90 * kDegree, 1 * kDegree, 30, {}};

/// The beams of one scan where they differ from its scanner's, in the laser's frame.
struct ScanBeams {
  double first_angle_rad = 0;
  double angle_step_rad = 0;  ///< counter-clockwise: positive
  double period_s = 0;        ///< from one beam to the next; negative: beam 0 was measured last
};

struct LaserScan {
  double stamp_s = 0;  ///< as recorded; recorded clocks may jump back
  double time_s = 0;   ///< of the middle beam; never decreasing: the recorded clock where it makes sense,
                       ///< mended where not
  std::vector<float> ranges_m;          ///< one a beam; 0: nothing usable
  std::size_t odometry_known = 0;       ///< how many odometry samples had been recorded when this scan was
  std::optional<ScanBeams> beams = {};  ///< none: those of the scanner, all measured at once
  std::size_t laser = 0;                ///< index in LaserLog::lasers
  long line = 0;                        ///< of the recording, or the number of its message; 0: not recorded
};

struct OdometrySample {
  double time_s = 0;  ///< on the same mended clock as the scans
  Pose2 T_odom_vehicle;
  long line = 0;  ///< as in LaserScan
};

/// What a vehicle with a laser scanner recorded on one run, in the order of recording.
struct LaserLog {
  std::vector<LaserScanner> lasers{1};  ///< at least one
  std::vector<LaserScan> scans;
  std::vector<OdometrySample> odometry;

  const LaserScanner& laser() const { return lasers.front(); }
  LaserScanner& laser() { return lasers.front(); }
  /// The scanner that took a scan, with the scan's own beams.
  LaserScanner laser_of(const LaserScan& scan) const;

  /// Median time from one scan to the next [s]; 0 with fewer than two scans.
  double scan_period_s() const;
};

}  // namespace aisle
