#pragma once

#include <functional>
#include <utility>

#include "aisle/exploration/floor_distances.hpp"
#include "aisle/guidance/ways/car_search.hpp"

namespace aisle {

/// Ways of any length. What is farther away than a stage is not searched at once: the vehicle is led a stage
/// along the floor's own distances, and searches on from there.
class StagedSearch {
 public:
  StagedSearch(const CarSearchParams& params, const VehicleDescription& vehicle);
  StagedSearch(const StagedSearch&) = delete;
  StagedSearch& operator=(const StagedSearch&) = delete;

  /// To a pose that is good enough, which lies about a place. The floor must outlive the search.
  /// @param about_m  so far from the place it may lie
  void look_for(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                const Vec2& p_map_place, double about_m, CarSearch::IsGoal is_goal);

  /// Exactly to a pose; from where the vehicle stands, once it has come within a stage of it.
  void look_for_way_to(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_goal,
                       const Pose2& T_map_vehicle);

  /// See CarSearch; of the search that was begun.
  void keep_to(std::function<bool(const Pose2& T_map_vehicle)> is_free) {
    search_.keep_to(std::move(is_free));
  }
  void forbid_first(int direction) { search_.forbid_first(direction); }
  void squeeze() { search_.squeeze(); }
  CarSearch::State advance(const FloorGrid& floor, const FloorClearance& clearance, int expansions) {
    return search_.advance(floor, clearance, expansions);
  }
  void stop() { search_.stop(); }

  CarSearch::State state() const { return search_.state(); }
  const FootprintRoom& room() const { return search_.room(); }
  Path path() const { return search_.path(); }
  int expansions() const { return search_.expansions(); }
  double reached_m() const { return search_.reached_m(); }
  bool has_tried_all() const { return search_.has_tried_all(); }
  bool has_come_to(const Vec2& p_map, double within_m) const { return search_.has_come_to(p_map, within_m); }
  /// What was found, or is searched, ends where a stage does.
  bool is_stage() const { return is_stage_; }

 private:
  double measure(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                 const Vec2& p_map_place);
  double left_m(const Vec2& p_map) const;

  CarSearchParams params_;
  double half_width_m_;
  CarSearch search_;
  FloorDistances distances_;
  const FloorGrid* floor_ = nullptr;  ///< of `distances_`
  Vec2 p_map_place_ = Vec2::Zero();   ///< what `distances_` are measured from
  bool is_stage_ = false;
};

}  // namespace aisle
