#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct RetryBudgetParams {
  double time_s = 90;       ///< for a target without learning anything, and ...
  double time_s_per_m = 8;  ///< ... so much more for each metre of path to it
  double path_m = 12;       ///< that may be driven for it, and ...
  double path_factor = 3;   ///< ... so much more for each metre of path to it
  int hitches = 5;          ///< paths that may fail on one spot

  void describe(FieldList& fields);
};

/// Ends what leads nowhere: a vehicle that wants to get to a target, and neither comes nearer to it nor
/// learns anything on the way.
class RetryBudget {
 public:
  explicit RetryBudget(const RetryBudgetParams& params) : params_(params) {}

  /// A target was chosen, or something was learned: everything begin again.
  void renew(double stamp_s, double path_m, double target_m);
  /// A path of this length was found: it may be driven to its end, however near the target had seemed.
  void allow(double stamp_s, double path_m, double found_m);
  /// A path could not be driven to its end, or there was none, while the vehicle stood here.
  void count_failure(const Pose2& T_map_vehicle);
  bool is_over(double stamp_s, double path_m) const;

 private:
  RetryBudgetParams params_;
  double until_s_ = 0;
  double until_m_ = 0;
  int hitches_ = 0;
  Pose2 T_map_failure_;
};

}  // namespace aisle
