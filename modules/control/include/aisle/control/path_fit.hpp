#pragma once

#include <span>

#include "aisle/control/path.hpp"
#include "aisle/core/parameters.hpp"

namespace aisle {

struct PathFitParams {
  double stray_max_m = 0.12;  ///< what was driven is at most this far from the path
  double radius_min_m = 0.6;  ///< of an arc, where the stray allows it

  void describe(FieldList& fields);
};

/// Smooths a driven path into a few lines and arcs that join without a kink: hand-driven wander within
/// `stray_max_m` goes, corners stay. A segment driven backwards becomes pieces of negative length, a turn on
/// the spot an arc of length 0. If no such path stays close enough (the driven poses jump), the result goes
/// straight from position to position with turns on the spot between.
/// @param driven  base_link in `map`, in order, at least two different positions, else std::invalid_argument
Path fit_path(std::span<const Pose2> driven, const PathFitParams& params);

}  // namespace aisle
