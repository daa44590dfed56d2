#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "aisle/exploration/floor_distances.hpp"
#include "aisle/guidance/paths/car_search.hpp"

namespace aisle {

/// Paths of any length. What is farther away than a stage is not searched at once: the vehicle is led a stage
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

  /// Of the search that look_for() began, before all else is given: what it does not find soon is searched
  /// from its ends as well, which are all poses in a box that are good enough.
  void search_from_ends_too(const FloorBox& places);

  /// Exactly to a pose; from where the vehicle stands, once it has come within a stage of it.
  void look_for_path_to(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_goal,
                        const Pose2& T_map_vehicle);

  /// See CarSearch; of the search that was begun.
  void keep_to(const std::function<bool(const Pose2& T_map_vehicle)>& is_free);
  void forbid_first(int direction);
  void relax_clearance();
  CarSearch::State advance(const FloorGrid& floor, const FloorClearance& clearance, int expansions);
  void stop();

  CarSearch::State state() const;
  const FootprintClearance& footprint_clearance() const { return search_.footprint_clearance(); }
  Path path() const { return is_found_from_ends() ? from_ends_.path() : search_.path(); }
  int expansions() const { return search_.expansions(); }
  double reached_m() const { return search_.reached_m(); }
  bool has_tried_all() const { return search_.has_tried_all(); }
  bool has_come_to(const Vec2& p_map, double within_m) const { return search_.has_come_to(p_map, within_m); }
  /// All was tried from the ends: no path leads from any of them to where the vehicle stands, nor so near to
  /// a place, unless the vehicle gets there, too.
  bool is_shut_off_from(const Vec2& p_map, double within_m) const {
    return ends_are_shut_off_ &&
           (search_.has_come_to(p_map, within_m) || !from_ends_.has_come_to(p_map, within_m));
  }
  /// What was found, or is searched, ends where a stage does.
  bool is_stage() const { return is_stage_ && !is_found_from_ends(); }

 private:
  /// Tells how far it is to a place.
  struct Guide {
    FloorDistances distances;
    Vec2 p_map_place = Vec2::Zero();
  };

  double measure(const FloorGrid& floor, const FloorClearance& clearance, const Vec2& p_map_from,
                 const Vec2& p_map_place, Guide& guide) const;
  double left_m(const Guide& guide, const Vec2& p_map) const;
  void begin(const FloorGrid& floor, const Pose2& T_map_vehicle);
  bool is_turn_of_ends() const;
  bool is_found_from_ends() const { return from_ends_.state() == CarSearch::State::kFound; }

  CarSearchParams params_;
  double half_width_m_;
  CarSearch search_;
  CarSearch from_ends_;
  CarSearch::IsGoal is_goal_;
  Pose2 T_map_vehicle_;
  const FloorGrid* floor_ = nullptr;
  Guide to_place_;
  std::optional<Guide> to_vehicle_;  ///< of a search from its ends, since it was its turn
  bool ends_are_shut_off_ = false;
  bool is_stage_ = false;
};

}  // namespace aisle
