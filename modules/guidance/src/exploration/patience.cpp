#include "aisle/guidance/exploration/patience.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kHitchSpot_m = 0.3;
constexpr double kHitchSpot_rad = 20 * kDegree;

}  // namespace

void PatienceParams::describe(FieldList& fields) {
  fields.real("time_s", time_s, {1, 3600}, "for a target without learning anything on the way to it");
  fields.real("time_s_per_m", time_s_per_m, {0, 100}, "more for each metre of way to it");
  fields.real("way_m", way_m, {1, 1000}, "that may be driven for it");
  fields.real("way_factor", way_factor, {1, 100}, "more for each metre of way to it");
  fields.count("hitches", hitches, {1, 100}, "ways that may fail on one spot");
}

void Patience::renew(double stamp_s, double way_m, double target_m) {
  until_s_ = stamp_s + params_.time_s + params_.time_s_per_m * target_m;
  until_m_ = way_m + params_.way_m + params_.way_factor * target_m;
  hitches_ = 0;
}

void Patience::allow(double stamp_s, double way_m, double found_m) {
  until_s_ = std::max(until_s_, stamp_s + params_.time_s + params_.time_s_per_m * found_m);
  until_m_ = std::max(until_m_, way_m + params_.way_factor * found_m);
}

void Patience::hitch(const Pose2& T_map_vehicle) {
  const Pose2 moved = between(T_map_hitch_, T_map_vehicle);
  const bool same_spot = moved.position().norm() < kHitchSpot_m && std::abs(moved.theta) < kHitchSpot_rad;
  hitches_ = same_spot ? hitches_ + 1 : 1;
  if (!same_spot) T_map_hitch_ = T_map_vehicle;
}

bool Patience::is_over(double stamp_s, double way_m) const {
  return stamp_s > until_s_ || way_m > until_m_ || hitches_ > params_.hitches;
}

}  // namespace aisle
