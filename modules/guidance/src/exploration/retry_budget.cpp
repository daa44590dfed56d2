#include "aisle/guidance/exploration/retry_budget.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kFailureSpot_m = 0.3;
constexpr double kFailureSpot_rad = 20 * kDegree;

}  // namespace

void RetryBudgetParams::describe(FieldList& fields) {
  fields.real("time_s", time_s, {1, 3600}, "spent on a target without learning anything new");
  fields.real("time_s_per_m", time_s_per_m, {0, 100}, "more for each metre of path to it");
  fields.real("path_m", path_m, {1, 1000}, "driven for a target without learning anything new");
  fields.real("path_factor", path_factor, {1, 100}, "more for each metre of path to it");
  fields.count("planning_failures", planning_failures, {1, 100}, "paths that may fail on one spot");
}

void RetryBudget::renew(double stamp_s, double path_m, double target_m) {
  until_s_ = stamp_s + params_.time_s + params_.time_s_per_m * target_m;
  until_m_ = path_m + params_.path_m + params_.path_factor * target_m;
  failures_ = 0;
}

void RetryBudget::allow(double stamp_s, double path_m, double found_m) {
  until_s_ = std::max(until_s_, stamp_s + params_.time_s + params_.time_s_per_m * found_m);
  until_m_ = std::max(until_m_, path_m + params_.path_factor * found_m);
}

void RetryBudget::count_failure(const Pose2& T_map_vehicle) {
  const Pose2 moved = between(T_map_failure_, T_map_vehicle);
  const bool same_spot = moved.position().norm() < kFailureSpot_m && std::abs(moved.theta) < kFailureSpot_rad;
  failures_ = same_spot ? failures_ + 1 : 1;
  if (!same_spot) T_map_failure_ = T_map_vehicle;
}

bool RetryBudget::is_over(double stamp_s, double path_m) const {
  return stamp_s > until_s_ || path_m > until_m_ || failures_ > params_.planning_failures;
}

}  // namespace aisle
