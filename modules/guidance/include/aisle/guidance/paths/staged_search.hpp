#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "aisle/exploration/floor_distances.hpp"
#include "aisle/guidance/paths/car_search.hpp"

namespace aisle {

/// Plans paths of any length. A goal farther away than a stage is not searched for at once: the vehicle is
/// led one stage along the floor's distance field, and the search goes on from there.
class StagedSearch {
 public:
  StagedSearch(const CarSearchParams& params, const VehicleDescription& vehicle);
  StagedSearch(const StagedSearch&) = delete;
  StagedSearch& operator=(const StagedSearch&) = delete;

  /// Searches for a path to any goal pose near a place. The floor must outlive the search.
  /// @param about_m  how far from the place goal poses may lie
  void look_for(const KnownFloor& floor, const Pose2& T_map_vehicle, const Vec2& p_map_place, double about_m,
                CarSearch::IsGoal is_goal);

  /// For the search that look_for() began, to be called before any other setting: if it finds no path soon, a
  /// second search runs backwards from all goal poses in a box.
  void search_from_ends_too(const FloorBox& places);

  /// Searches for a path that ends exactly at a pose; farther away than a stage, for its first stage.
  void look_for_path_to(const KnownFloor& floor, const Pose2& T_map_goal, const Pose2& T_map_vehicle);

  /// For the search that was begun; see CarSearch.
  void keep_to(const std::function<bool(const Pose2& T_map_vehicle)>& is_free);
  void forbid_first(std::optional<LegDirection> direction);
  void relax_clearance();
  void cross_unknown();
  CarSearch::State advance(const KnownFloor& floor, int expansions);
  void stop();

  CarSearch::State state() const;
  const FootprintClearance& footprint_clearance() const { return search_.footprint_clearance(); }
  Path path() const { return is_found_from_ends() ? from_ends_.path() : search_.path(); }
  int expansions() const { return search_.expansions(); }
  bool is_from_the_end() const { return search_.is_from_the_end(); }
  double reached_m() const { return search_.reached_m(); }
  bool has_tried_all() const { return search_.has_tried_all(); }
  bool has_come_to(const Vec2& p_map, double within_m) const { return search_.has_come_to(p_map, within_m); }
  /// The backward search tried everything: no path connects a goal pose with the vehicle, nor with the
  /// surroundings of a place, unless the vehicle can get there, too.
  bool is_shut_off_from(const Vec2& p_map, double within_m) const {
    return ends_are_shut_off_ &&
           (search_.has_come_to(p_map, within_m) || !from_ends_.has_come_to(p_map, within_m));
  }
  /// Whether the path found or searched for ends at the end of a stage, not at its goal.
  bool is_stage() const { return is_stage_ && !is_found_from_ends(); }

 private:
  /// Distances along the floor between a place and all others.
  struct Guide {
    FloorDistances distances;
    Vec2 p_map_place = Vec2::Zero();
  };

  double measure(const KnownFloor& floor, const Vec2& p_map_from, const Vec2& p_map_place,
                 FloorDistances::Paths paths, Guide& guide) const;
  double left_m(const Guide& guide, const Vec2& p_map) const;
  void begin(const KnownFloor& floor, const Pose2& T_map_vehicle);
  bool is_turn_of_ends() const;
  bool is_found_from_ends() const { return from_ends_.state() == CarSearch::State::kFound; }

  CarSearchParams params_;
  double half_width_m_;
  CarSearch search_;
  CarSearch from_ends_;
  CarSearch::IsGoal is_goal_;
  Pose2 T_map_vehicle_;
  const FloorGrid* grid_ = nullptr;
  Guide to_place_;
  std::optional<Guide> to_vehicle_;  ///< for the search from the ends, once it runs
  bool ends_are_shut_off_ = false;
  bool is_stage_ = false;
};

}  // namespace aisle
