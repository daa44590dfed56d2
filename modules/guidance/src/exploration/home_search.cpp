#include "aisle/guidance/exploration/home_search.hpp"

#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kStraight_m = 1;
constexpr double kAtHome_m = 0.03;
constexpr double kAtHome_rad = 1 * kDegree;

bool is_within(const Pose2& off, double within_m, double within_rad) {
  return off.position().norm() < within_m && std::abs(off.theta) < within_rad;
}

}  // namespace

Path HomeSearch::straight_in(const KnownFloor& floor, const Pose2& T_map_home,
                             const Pose2& T_map_from) const {
  const FootprintClearance& footprint_clearance = search_.footprint_clearance();
  const RelaxedClearance at_home = footprint_clearance.relaxed_clearance(floor, T_map_home);
  const double first_m = between(T_map_home, T_map_from).x > 0 ? -kStraight_m : kStraight_m;
  for (const double straight_m : {first_m, -first_m}) {
    const Arc arc{straight_m, 0};
    Path path({{T_map_home * end_pose(arc).inverse(), arc}});
    if (footprint_clearance.free_path_m(floor, path, 0, at_home) >= path.length_m()) return path;
  }
  return {};
}

void HomeSearch::look_for(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from,
                          Path way_in) {
  is_exact_ = true;
  way_in_ = std::move(way_in);
  search_.look_for_path_to(floor, way_in_.empty() ? T_map_home : way_in_.pieces().front().T_map_start,
                           T_map_from);
}

void HomeSearch::look_for_near(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from) {
  is_exact_ = false;
  search_.look_for(floor, T_map_from, T_map_home.position(), kNear_m, [T_map_home](const Pose2& T_map) {
    return is_within(between(T_map_home, T_map), kNear_m, kNear_rad);
  });
}

Path HomeSearch::path() const {
  return leads_home() ? search_.path().followed_by(way_in_) : search_.path();
}

bool stands_at_home(const Pose2& T_map_home, const Pose2& T_map_vehicle) {
  return is_within(between(T_map_home, T_map_vehicle), kAtHome_m, kAtHome_rad);
}

}  // namespace aisle
