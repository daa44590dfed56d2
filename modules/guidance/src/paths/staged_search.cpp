#include "aisle/guidance/paths/staged_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kLeeway_m = 1;         // around a place, where less clearance will do
constexpr double kBeside_m = 0.5;       // the vehicle's distance is read off within this distance of it
constexpr double kOffKnownFloor_m = 2;  // detour assumed for places from which no path is known
constexpr double kStageSlack = 1.5;  // in stages: a goal that is little farther than one is searched at once
constexpr int kSoonExpansions = 30000;  // then the backward search takes over

bool found_none_at_all(const CarSearch& search) {
  return search.state() == CarSearch::State::kNone && search.has_tried_all();
}

}  // namespace

StagedSearch::StagedSearch(const CarSearchParams& params, const VehicleDescription& vehicle)
    : params_(params),
      half_width_m_(vehicle.footprint.width_m / 2),
      search_(params, vehicle),
      from_ends_(params, vehicle) {}

double StagedSearch::left_m(const Guide& guide, const Vec2& p_map) const {
  const float left = guide.distances.to(grid_->cell_at(p_map));
  return std::isfinite(left) ? left : (p_map - guide.p_map_place).norm() + kOffKnownFloor_m;
}

/// Distance between a place and another, with the search's margin, or else with the vehicle's width only.
double StagedSearch::measure(const KnownFloor& floor, const Vec2& p_map_from, const Vec2& p_map_place,
                             FloorDistances::Paths paths, Guide& guide) const {
  guide.p_map_place = p_map_place;
  float path_m = FloorDistances::kUnreached;
  for (const double clearance_m : {half_width_m_ + params_.margin_m, half_width_m_}) {
    guide.distances.measure(floor, p_map_place, clearance_m, kLeeway_m, paths);
    path_m = guide.distances.near(floor.grid(), p_map_from, kBeside_m);
    if (std::isfinite(path_m)) break;
  }
  return path_m;
}

void StagedSearch::begin(const KnownFloor& floor, const Pose2& T_map_vehicle) {
  grid_ = &floor.grid();
  T_map_vehicle_ = T_map_vehicle;
  is_stage_ = ends_are_shut_off_ = false;
  from_ends_.stop();
}

void StagedSearch::look_for(const KnownFloor& floor, const Pose2& T_map_vehicle, const Vec2& p_map_place,
                            double about_m, CarSearch::IsGoal is_goal) {
  begin(floor, T_map_vehicle);
  is_goal_ = std::move(is_goal);
  const double left_now_m =
      measure(floor, T_map_vehicle.position(), p_map_place, FloorDistances::Paths::kToStart, to_place_);
  const bool is_far = std::isfinite(left_now_m) && left_now_m > kStageSlack * params_.stage_m + about_m;
  const double stage_end_m = is_far ? left_now_m - params_.stage_m : -1;
  search_.look_for(
      T_map_vehicle,
      [this, stage_end_m](const Pose2& T_map) {
        const bool is_there = is_goal_(T_map);
        is_stage_ = !is_there && to_place_.distances.to(grid_->cell_at(T_map.position())) <= stage_end_m;
        return is_there || is_stage_;
      },
      [this, about_m](const Vec2& p_map) { return std::max(0.0, left_m(to_place_, p_map) - about_m); });
}

void StagedSearch::search_from_ends_too(const FloorBox& places) {
  to_vehicle_.reset();
  from_ends_.look_for_path_to_any(is_goal_, places, T_map_vehicle_,
                                  [this](const Vec2& p_map) { return left_m(*to_vehicle_, p_map); });
}

void StagedSearch::look_for_path_to(const KnownFloor& floor, const Pose2& T_map_goal,
                                    const Pose2& T_map_vehicle) {
  begin(floor, T_map_vehicle);
  const double left_now_m = measure(floor, T_map_vehicle.position(), T_map_goal.position(),
                                    FloorDistances::Paths::kToStart, to_place_);
  if (std::isfinite(left_now_m) && left_now_m > kStageSlack * params_.stage_m) {
    return look_for(floor, T_map_vehicle, T_map_goal.position(), 0, [](const Pose2&) { return false; });
  }
  measure(floor, T_map_goal.position(), T_map_vehicle.position(), FloorDistances::Paths::kFromStart,
          to_place_);
  search_.look_for_path_to(T_map_goal, T_map_vehicle,
                           [this](const Vec2& p_map) { return left_m(to_place_, p_map); });
}

void StagedSearch::keep_to(const std::function<bool(const Pose2&)>& is_free) {
  search_.keep_to(is_free);
  from_ends_.keep_to(is_free);
}

void StagedSearch::forbid_first(std::optional<LegDirection> direction) {
  search_.forbid_first(direction);
  from_ends_.forbid_first(direction);
}

void StagedSearch::relax_clearance() {
  search_.relax_clearance();
  from_ends_.relax_clearance();
}

void StagedSearch::cross_unknown() {
  search_.cross_unknown();
  from_ends_.cross_unknown();
}

bool StagedSearch::is_turn_of_ends() const {
  return from_ends_.state() == CarSearch::State::kSearching &&
         search_.state() == CarSearch::State::kSearching && search_.expansions() >= kSoonExpansions;
}

/// If both searches reached a common pose, there may be a path although neither found one.
CarSearch::State StagedSearch::advance(const KnownFloor& floor, int expansions) {
  if (!is_turn_of_ends()) {
    search_.advance(floor, expansions);
    return state();
  }
  if (!to_vehicle_)
    measure(floor, to_place_.p_map_place, T_map_vehicle_.position(), FloorDistances::Paths::kFromStart,
            to_vehicle_.emplace(Guide{}));
  from_ends_.advance(floor, expansions);
  ends_are_shut_off_ = found_none_at_all(from_ends_) && !from_ends_.meets(search_);
  return state();
}

void StagedSearch::stop() {
  search_.stop();
  from_ends_.stop();
}

CarSearch::State StagedSearch::state() const {
  if (search_.state() != CarSearch::State::kSearching) return search_.state();
  if (is_found_from_ends()) return CarSearch::State::kFound;
  return ends_are_shut_off_ ? CarSearch::State::kNone : CarSearch::State::kSearching;
}

}  // namespace aisle
