#pragma once

#include "aisle/exploration/building_explorer.hpp"
#include "aisle/guidance/exploration/floor_learner.hpp"
#include "aisle/guidance/exploration/home_search.hpp"

namespace aisle {

/// What was tried for one target so far.
struct TargetTries {
  static constexpr int kFailuresNear = 2;

  int paths = 0;     ///< were driven and did not settle it
  int failures = 0;  ///< searches found no path

  /// The vehicle does not get near, not even where it relaxes its clearance through.
  bool look_from_afar() const { return failures >= kFailuresNear; }
};

struct TargetDistances {
  double look_from_m = 2.5;      ///< so near to what it wants to see
  double pocket_reach_m = 3;     ///< so near to a pocket
  double crossing_near_m = 0.5;  ///< so near to a crossing the vehicle is back at it
};

/// Paths to what an explorer wants next: to a pose that shows a path, back to a crossing, home.
class TargetSearch {
 public:
  /// @param search   by which paths are searched; outlives this, as does
  /// @param learner  what is known
  /// @param front_m  of the vehicle, from its origin
  TargetSearch(StagedSearch& search, const FloorLearner& learner, const TargetDistances& distances,
               double front_m);
  TargetSearch(const TargetSearch&) = delete;
  TargetSearch& operator=(const TargetSearch&) = delete;

  /// Begins to look for a path from a pose. A path home ends exactly there, or near it.
  void look_for(const ExploringTarget& target, const Pose2& T_map_from, const TargetTries& tries,
                bool exactly_home);
  /// Of the search for a frontier that was begun; see StagedSearch.
  void search_from_ends_too(const TargetTries& tries);
  /// The frontier that is looked for, as it is seen by now.
  void see(const Frontier& frontier) { frontier_ = frontier; }

  /// What was found, or is searched, ends exactly at home.
  bool leads_home() const { return goes_home_ && home_search_.leads_home(); }
  /// What was found. Empty: the vehicle is there already.
  Path path() const { return goes_home_ ? home_search_.path() : search_.path(); }

 private:
  void look_into_frontier(const Pose2& T_map_from, const TargetTries& tries);
  void look_for_crossing(const Vec2& p_map_crossing, const Pose2& T_map_from);
  void look_for_home(const Pose2& T_map_from, bool exactly);
  double look_from_m(const TargetTries& tries) const;

  StagedSearch& search_;
  const FloorLearner& learner_;
  TargetDistances distances_;
  double front_m_;
  HomeSearch home_search_;
  Frontier frontier_;
  bool goes_home_ = false;
};

}  // namespace aisle
