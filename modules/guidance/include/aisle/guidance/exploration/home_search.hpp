#pragma once

#include "aisle/guidance/paths/staged_search.hpp"

namespace aisle {

/// Paths to where a vehicle began, on which it comes to stand as it stood: straight at the end, where there
/// is room for it.
class HomeSearch {
 public:
  static constexpr double kNear_m = 1.5;  ///< near home, and ...
  static constexpr double kNear_rad = 30 * kDegree;

  /// @param search  by which paths are searched; must outlive this
  explicit HomeSearch(StagedSearch& search) : search_(search) {}
  HomeSearch(const HomeSearch&) = delete;
  HomeSearch& operator=(const HomeSearch&) = delete;

  /// Begins to look for a path that ends exactly at home, or for the next stage of it.
  void look_for(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_home,
                const Pose2& T_map_from);
  /// Begins to look for a path that ends near home.
  void look_for_near(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_home,
                     const Pose2& T_map_from);

  /// What was found, or is searched, ends exactly at home.
  bool leads_home() const { return is_exact_ && !search_.is_stage(); }
  /// What was found, to its very end. Empty: the vehicle is there already.
  Path path() const;

 private:
  Arc run_in(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_from) const;
  Pose2 T_map_run_in() const { return T_map_home_ * end_pose(run_in_).inverse(); }

  StagedSearch& search_;
  Pose2 T_map_home_;
  Arc run_in_;  ///< with which the path ends
  bool is_exact_ = false;
};

/// By its own account, a vehicle stands where it began.
bool stands_at_home(const Pose2& T_map_home, const Pose2& T_map_vehicle);

}  // namespace aisle
