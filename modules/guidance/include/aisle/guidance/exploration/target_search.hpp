#pragma once

#include "aisle/exploration/building_explorer.hpp"
#include "aisle/guidance/exploration/floor_learner.hpp"
#include "aisle/guidance/exploration/home_search.hpp"

namespace aisle {

/// What has been tried for one target so far.
struct TargetTries {
  static constexpr int kFailuresNear = 2;

  int paths = 0;       ///< driven without settling it
  int failures = 0;    ///< searches without a path
  bool probe = false;  ///< the present search may cross unknown floor, where the vehicle was put

  /// The vehicle cannot get near, not even with relaxed clearance: it looks from farther away.
  bool look_from_afar() const { return failures >= kFailuresNear; }
};

struct TargetDistances {
  double look_from_m = 2.5;      ///< from which a frontier is looked at
  double pocket_reach_m = 3;     ///< from which an occluded pocket is looked at
  double crossing_near_m = 0.5;  ///< so near to a crossing the vehicle is back at it
};

/// Plans paths to an explorer's next target: to a pose that sees a frontier, back to a crossing, or home.
class TargetSearch {
 public:
  /// @param search   must outlive this
  /// @param learner  the known floor; must outlive this
  /// @param front_m  from the vehicle's origin to its front
  TargetSearch(StagedSearch& search, const FloorLearner& learner, const TargetDistances& distances,
               double front_m);
  TargetSearch(const TargetSearch&) = delete;
  TargetSearch& operator=(const TargetSearch&) = delete;

  /// Begins the search for a path from a pose. A path home ends exactly there, or near it.
  /// @param trail_in  the vehicle's own trail into its first pose, as it left it; empty: there is none
  void look_for(const ExploringTarget& target, const Pose2& T_map_from, const TargetTries& tries,
                bool exactly_home, const Path& trail_in);
  /// For the search for a frontier that was begun; see StagedSearch.
  void search_from_ends_too(const TargetTries& tries);
  /// Updates the frontier that is searched for.
  void see(const Frontier& frontier) { frontier_ = frontier; }

  /// Whether the path found or searched for ends exactly at home.
  bool leads_home() const { return goes_home_ && home_search_.leads_home(); }
  /// Length of the path's last part that leads along the vehicle's own trail.
  double trail_m() const { return leads_home() ? trail_m_ : 0; }
  /// The path found. Empty: the vehicle is there already.
  Path path() const { return goes_home_ ? home_search_.path() : search_.path(); }

 private:
  void look_into_frontier(const Pose2& T_map_from, const TargetTries& tries);
  void look_for_crossing(const Vec2& p_map_crossing, const Pose2& T_map_from);
  void look_for_home(const Pose2& T_map_from, const TargetTries& tries, const Path& trail_in);
  double look_from_m(const TargetTries& tries) const;

  StagedSearch& search_;
  const FloorLearner& learner_;
  TargetDistances distances_;
  double front_m_;
  HomeSearch home_search_;
  Frontier frontier_;
  bool goes_home_ = false;
  double trail_m_ = 0;  ///< of a path home: its last part, along the trail
};

}  // namespace aisle
