#pragma once

#include "aisle/guidance/paths/staged_search.hpp"

namespace aisle {

/// Plans paths back to the start pose.
class HomeSearch {
 public:
  static constexpr double kNear_m = 1.5;  ///< a pose within both limits is near home
  static constexpr double kNear_rad = 30 * kDegree;
  /// Of a path home: here the floor may show less clearance than the vehicle had when it started.
  static constexpr double kLast_m = 0.1;

  /// @param search  must outlive this
  explicit HomeSearch(StagedSearch& search) : search_(search) {}
  HomeSearch(const HomeSearch&) = delete;
  HomeSearch& operator=(const HomeSearch&) = delete;

  /// A straight last metre of a path, so that the vehicle stops exactly as it stood at the start: from the
  /// side where the vehicle is, if there is space; else from the other side. Empty: neither.
  Path straight_in(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from) const;
  /// Begins the search for a path that ends exactly at home, or for the next stage of it.
  /// @param way_in  the last part of the path, which ends at home; empty: that is searched, too
  void look_for(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from, Path way_in);
  /// Begins the search for a path that ends near home.
  void look_for_near(const KnownFloor& floor, const Pose2& T_map_home, const Pose2& T_map_from);

  /// Whether the path found or searched for ends exactly at home.
  bool leads_home() const { return is_exact_ && !search_.is_stage(); }
  /// The path found, with its last part. Empty: the vehicle is there already.
  Path path() const;

 private:
  StagedSearch& search_;
  Path way_in_;
  bool is_exact_ = false;
};

/// Whether the vehicle stands at its start pose, by its own pose estimate.
bool stands_at_home(const Pose2& T_map_home, const Pose2& T_map_vehicle);

}  // namespace aisle
