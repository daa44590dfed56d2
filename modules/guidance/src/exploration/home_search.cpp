#include "aisle/guidance/exploration/home_search.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kRunIn_m = 1;  // straight end of the path
constexpr double kAtHome_m = 0.03;
constexpr double kAtHome_rad = 1 * kDegree;

bool is_within(const Pose2& off, double within_m, double within_rad) {
  return off.position().norm() < within_m && std::abs(off.theta) < within_rad;
}

}  // namespace

void HomeSearch::look_for(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from) {
  is_exact_ = true;
  T_map_home_ = T_map_home;
  run_in_ = run_in(floor, T_map_from);
  search_.look_for_path_to(floor, T_map_run_in(), T_map_from);
}

void HomeSearch::look_for_near(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from) {
  is_exact_ = false;
  search_.look_for(floor, T_map_from, T_map_home.position(), kNear_m, [T_map_home](const Pose2& T_map) {
    return is_within(between(T_map_home, T_map), kNear_m, kNear_rad);
  });
}

Path HomeSearch::path() const {
  Path found = search_.path();
  if (!leads_home() || run_in_.length_m == 0) return found;
  const Pose2 T_map_begin = found.empty() ? T_map_run_in() : found.end();
  return found.followed_by(Path({{T_map_begin, run_in_}}));
}

/// From the side where the vehicle is, if there is space; else from the other side. Zero length: neither.
Arc HomeSearch::run_in(const KnownFloor& floor, const Pose2& T_map_from) const {
  const FootprintClearance& footprint_clearance = search_.footprint_clearance();
  const RelaxedClearance at_home = footprint_clearance.relaxed_clearance(floor, T_map_home_);
  const double first_m = between(T_map_home_, T_map_from).x > 0 ? -kRunIn_m : kRunIn_m;
  for (const double run_in_m : {first_m, -first_m}) {
    const Arc run_in{run_in_m, 0};
    const Path path({{T_map_home_ * end_pose(run_in).inverse(), run_in}});
    if (footprint_clearance.free_path_m(floor, path, 0, at_home) >= path.length_m()) return run_in;
  }
  return {};
}

bool stands_at_home(const Pose2& T_map_home, const Pose2& T_map_vehicle) {
  return is_within(between(T_map_home, T_map_vehicle), kAtHome_m, kAtHome_rad);
}

}  // namespace aisle
