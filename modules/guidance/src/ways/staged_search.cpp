#include "aisle/guidance/ways/staged_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kLeeway_m = 1;         // about a place, where there may be less room than elsewhere
constexpr double kBeside_m = 0.5;       // so near to the vehicle there is room for a disc
constexpr double kOffKnownFloor_m = 2;  // how much farther places seem from which no way is known
constexpr double kStageSpare = 1.5;     // in stages: what is a little farther than one is searched at once

}  // namespace

StagedSearch::StagedSearch(const CarSearchParams& params, const VehicleDescription& vehicle)
    : params_(params), half_width_m_(vehicle.footprint.width_m / 2), search_(params, vehicle) {}

double StagedSearch::left_m(const Vec2& p_map) const {
  const float left = distances_.to(floor_->cell_at(p_map));
  return std::isfinite(left) ? left : (p_map - p_map_place_).norm() + kOffKnownFloor_m;
}

/// How far the vehicle has to go: with the room that the search keeps, or else with as little as the vehicle
/// is wide.
double StagedSearch::measure(const FloorGrid& floor, const FloorClearance& clearance,
                             const Pose2& T_map_vehicle, const Vec2& p_map_place) {
  floor_ = &floor;
  p_map_place_ = p_map_place;
  float way_m = FloorDistances::kUnreached;
  for (const double room_m : {half_width_m_ + params_.margin_m, half_width_m_}) {
    distances_.measure(floor, clearance, p_map_place, room_m, kLeeway_m);
    way_m = distances_.near(floor, T_map_vehicle.position(), kBeside_m);
    if (std::isfinite(way_m)) break;
  }
  return way_m;
}

void StagedSearch::look_for(const FloorGrid& floor, const FloorClearance& clearance,
                            const Pose2& T_map_vehicle, const Vec2& p_map_place, double about_m,
                            CarSearch::IsGoal is_goal) {
  const double left_now_m = measure(floor, clearance, T_map_vehicle, p_map_place);
  const bool is_far = std::isfinite(left_now_m) && left_now_m > kStageSpare * params_.stage_m + about_m;
  const double stage_end_m = is_far ? left_now_m - params_.stage_m : -1;
  is_stage_ = false;
  search_.look_for(
      T_map_vehicle,
      [this, stage_end_m, is_goal = std::move(is_goal)](const Pose2& T_map) {
        const bool is_there = is_goal(T_map);
        is_stage_ = !is_there && distances_.to(floor_->cell_at(T_map.position())) <= stage_end_m;
        return is_there || is_stage_;
      },
      [this, about_m](const Vec2& p_map) { return std::max(0.0, left_m(p_map) - about_m); });
}

void StagedSearch::look_for_way_to(const FloorGrid& floor, const FloorClearance& clearance,
                                   const Pose2& T_map_goal, const Pose2& T_map_vehicle) {
  const double left_now_m = measure(floor, clearance, T_map_vehicle, T_map_goal.position());
  if (std::isfinite(left_now_m) && left_now_m > kStageSpare * params_.stage_m) {
    return look_for(floor, clearance, T_map_vehicle, T_map_goal.position(), 0,
                    [](const Pose2&) { return false; });
  }
  is_stage_ = false;
  measure(floor, clearance, T_map_goal, T_map_vehicle.position());
  search_.look_for_way_to(T_map_goal, T_map_vehicle, [this](const Vec2& p_map) { return left_m(p_map); });
}

}  // namespace aisle
