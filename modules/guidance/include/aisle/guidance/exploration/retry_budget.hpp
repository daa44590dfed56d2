#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct RetryBudgetParams {
  double time_s = 90;         ///< for a target, without learning anything new, plus ...
  double time_s_per_m = 8;    ///< ... this for each metre of path to it
  double path_m = 12;         ///< driven for a target, plus ...
  double path_factor = 3;     ///< ... this for each metre of path to it
  int planning_failures = 5;  ///< paths that may fail on one spot

  void describe(FieldList& fields);
};

/// Limits the time, path and failures spent on one target while nothing new is learned.
class RetryBudget {
 public:
  explicit RetryBudget(const RetryBudgetParams& params) : params_(params) {}

  /// A target was chosen, or something was learned: the whole budget starts again.
  /// @param path_m    distance travelled so far
  /// @param target_m  path to the target
  void renew(double stamp_s, double path_m, double target_m);
  /// A path of length `found_m` was found: it may be driven to its end, even if the target had seemed nearer.
  void allow(double stamp_s, double path_m, double found_m);
  /// While the vehicle stood here, no path was found, or one could not be driven to its end.
  void count_failure(const Pose2& T_map_vehicle);
  bool is_over(double stamp_s, double path_m) const;

 private:
  RetryBudgetParams params_;
  double until_s_ = 0;
  double until_m_ = 0;
  int failures_ = 0;
  Pose2 T_map_failure_;
};

}  // namespace aisle
