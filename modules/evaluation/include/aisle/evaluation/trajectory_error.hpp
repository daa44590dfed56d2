#pragma once
/// How far a trajectory is off the true poses, once it is laid onto them.

#include <cstddef>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/trajectory.hpp"

namespace aisle {

/// Of errors that are not negative.
struct ErrorSpread {
  double mean = 0, rms = 0, max = 0;
};

struct TrajectoryError {
  std::size_t compared = 0;         ///< poses with a truth at their time
  std::size_t without_truth = 0;    ///< the others
  Pose2 T_truth_map;                ///< lays the trajectory onto the truth
  double heading_offset_rad = 0;    ///< of the true body against the vehicle, taken out of the errors
  ErrorSpread position_m;           ///< absolute trajectory error
  ErrorSpread heading_rad;          ///< absolute; of magnitudes
  double step_m = 0;                ///< relative errors are over pieces of the path that are this long
  ErrorSpread relative_position_m;  ///< all zero if the path is shorter
  ErrorSpread relative_heading_rad;
  std::vector<double> stamps_s;        ///< of the poses compared
  std::vector<Pose2> T_truth_vehicle;  ///< the trajectory, laid onto the truth
  std::vector<Pose2> T_truth_true;     ///< the truth at the same times
};

/// Compares poses with true ones that are interpolated to their stamps, but not over gaps of the truth of
/// more than 0.25 s. The alignment is the rotation and translation that make the squares of the distances
/// least: there is no scale. True headings may have another zero: their mean difference is taken out.
/// @param step_m  > 0
/// @return problems if fewer than three poses have a truth, or if stamps of the truth do not grow
Result<TrajectoryError> trajectory_error(const Trajectory& trajectory, const Trajectory& truth,
                                         double step_m);

}  // namespace aisle
