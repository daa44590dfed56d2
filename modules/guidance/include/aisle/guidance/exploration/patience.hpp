#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct PatienceParams {
  double time_s = 90;       ///< for a target without learning anything, and ...
  double time_s_per_m = 8;  ///< ... so much more for each metre of way to it
  double way_m = 12;        ///< that may be driven for it, and ...
  double way_factor = 3;    ///< ... so much more for each metre of way to it
  int hitches = 5;          ///< ways that may fail on one spot

  void describe(FieldList& fields);
};

/// Ends what leads nowhere: a vehicle that wants to get to a target, and neither comes nearer to it nor
/// learns anything on the way.
class Patience {
 public:
  explicit Patience(const PatienceParams& params) : params_(params) {}

  /// A target was chosen, or something was learned: everything begins anew.
  void renew(double stamp_s, double way_m, double target_m);
  /// A way of this length was found: it may be driven to its end, however near the target had seemed.
  void allow(double stamp_s, double way_m, double found_m);
  /// A way could not be driven to its end, or there was none, while the vehicle stood here.
  void hitch(const Pose2& T_map_vehicle);
  bool is_over(double stamp_s, double way_m) const;

 private:
  PatienceParams params_;
  double until_s_ = 0;
  double until_m_ = 0;
  int hitches_ = 0;
  Pose2 T_map_hitch_;
};

}  // namespace aisle
