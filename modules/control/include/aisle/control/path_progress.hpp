#pragma once

#include "aisle/control/path.hpp"

namespace aisle {

/// How far a vehicle has come along a path. It never skips: where the path crosses itself, the vehicle stays
/// on its leg. The next leg begins when this one has been driven to its end, or turned to its heading.
class PathProgress {
 public:
  /// @param path  not empty; must outlive the progress
  /// @param along_m  where the vehicle is to begin with
  explicit PathProgress(const Path& path, double along_m = 0);
  /// Continues on a path that is the same up to a point and on the leg through it.
  PathProgress(const Path& path, const PathPoint& from);

  /// Moves on to where the path is nearest to the vehicle, at most 1 m ahead or 0.5 m back.
  const PathPoint& advance(const Pose2& T_map_vehicle);

  /// Continues elsewhere on the path, for a vehicle that was lost: at the nearest point within `off_max_m`
  /// [m] where the path points as the vehicle does. If the path passes by more than once, the pass that is
  /// nearest along the path to the last progress is taken.
  /// @return whether there is one; else nothing changes
  bool find(const Pose2& T_map_vehicle, double off_max_m);

  const PathPoint& point() const { return point_; }
  /// The last leg has been driven to its end.
  bool has_arrived() const { return has_arrived_; }

 private:
  void move_on_leg(const Vec2& p_map);
  bool is_leg_done(const Pose2& T_map_vehicle) const;

  const Path* path_;
  PathPoint point_;
  std::size_t leg_begin_ = 0;
  bool has_arrived_ = false;
};

}  // namespace aisle
