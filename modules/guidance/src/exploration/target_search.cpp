#include "aisle/guidance/exploration/target_search.hpp"

#include <cmath>

#include "aisle/guidance/exploration/frontier_view.hpp"

namespace aisle {
namespace {

constexpr double kAfar = 2;            // factor on the distance where it cannot get near
constexpr double kAboutStand_m = 1.5;  // poses that show a pocket are searched within this distance of one

}  // namespace

TargetSearch::TargetSearch(StagedSearch& search, const FloorLearner& learner,
                           const TargetDistances& distances, double front_m)
    : search_(search), learner_(learner), distances_(distances), front_m_(front_m), home_search_(search) {}

void TargetSearch::look_for(const ExploringTarget& target, const Pose2& T_map_from, const TargetTries& tries,
                            bool exactly_home, const Path& trail_in) {
  goes_home_ = target.kind == ExploringTarget::Kind::kHome;
  switch (target.kind) {
    case ExploringTarget::Kind::kPath:
      see(target.frontier);
      return look_into_frontier(T_map_from, tries);
    case ExploringTarget::Kind::kCrossing:
      return look_for_crossing(target.T_map_back.position(), T_map_from);
    case ExploringTarget::Kind::kHome:
      if (exactly_home) return look_for_home(T_map_from, tries, trail_in);
      return home_search_.look_for_near(learner_.floor(), learner_.T_map_home(), T_map_from);
  }
}

/// To a pose that would see enough of the frontier's edge.
void TargetSearch::look_into_frontier(const Pose2& T_map_from, const TargetTries& tries) {
  const double reach_m = look_from_m(tries);
  const bool one_point_is_enough = tries.failures > 0;
  const auto shows_frontier = [this, reach_m, one_point_is_enough](const Pose2& T_map) {
    const FrontierLook look{learner_.sensor().scanner(), learner_.view().near_m, reach_m};
    const std::size_t enough = one_point_is_enough ? 1 : (frontier_.edge.size() + 3) / 4;
    return sees_frontier(look, learner_.floor(), T_map, frontier_, enough);
  };
  search_.look_for(
      learner_.floor(), T_map_from,
      frontier_.is_pocket ? learner_.floor().grid().centre(frontier_.viewpoint) : frontier_.p_map,
      frontier_.is_pocket ? kAboutStand_m : reach_m + front_m_, shows_frontier);
}

/// All poses that see a part of the frontier's edge lie around it.
void TargetSearch::search_from_ends_too(const TargetTries& tries) {
  const FloorGrid& grid = learner_.floor().grid();
  FloorBox places;
  for (const Vec2& p_map : frontier_.edge) places.include(grid.cell_at(p_map));
  const double beside_m = look_from_m(tries) + front_m_;
  search_.search_from_ends_too(places.widened(static_cast<int>(std::ceil(beside_m / grid.cell_m()))));
}

void TargetSearch::look_for_crossing(const Vec2& p_map_crossing, const Pose2& T_map_from) {
  const double near_m = distances_.crossing_near_m / 2;
  search_.look_for(learner_.floor(), T_map_from, p_map_crossing, 0,
                   [=](const Pose2& T_map) { return (T_map.position() - p_map_crossing).norm() < near_m; });
}

/// After a straight metre; if no path leads there, any other way or as the vehicle left it, in turn.
void TargetSearch::look_for_home(const Pose2& T_map_from, const TargetTries& tries, const Path& trail_in) {
  const KnownFloor& floor = learner_.floor();
  const Pose2& T_map_home = learner_.T_map_home();
  const bool is_first = tries.failures == 0, is_by_trail = !is_first && tries.failures % 2 == 0;
  trail_m_ = is_by_trail ? trail_in.length_m() : 0;
  home_search_.look_for(floor, T_map_home, T_map_from,
                        is_first      ? home_search_.straight_in(floor, T_map_home, T_map_from)
                        : is_by_trail ? trail_in
                                      : Path());
}

/// Nearer where the vehicle has seen nothing yet, farther where it cannot get so near.
double TargetSearch::look_from_m(const TargetTries& tries) const {
  if (frontier_.is_pocket) return distances_.pocket_reach_m;
  if (tries.look_from_afar()) return kAfar * distances_.look_from_m;
  return tries.paths < 2 ? distances_.look_from_m : distances_.look_from_m / 2;
}

}  // namespace aisle
