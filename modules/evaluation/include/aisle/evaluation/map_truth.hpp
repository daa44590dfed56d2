#pragma once

#include <cstddef>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How a learned map lies in the world, given by the taught run. The map's drift over a long path is not an
/// error of driving by it, so the vehicle's pose on the map is judged against the nearest pose of that run.
class MapTruth {
 public:
  MapTruth() = default;
  /// Both have the same time stamps; not empty.
  MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught);

  bool empty() const { return T_map_taught_.empty(); }

  /// Index of the taught pose nearest to a pose.
  std::size_t nearest(const Pose2& T_map_place) const;
  /// Indices of the taught poses nearest to a route's path, or to its return path, every kAlongStep_m from
  /// its start. They follow the order of teaching, so that a path that passes the same place twice is not
  /// mixed up.
  std::vector<std::size_t> along(const Path& path, bool in_reverse) const;
  static constexpr double kAlongStep_m = 0.05;
  /// Index of the taught pose from which a route, or its return path, begins.
  std::size_t start(bool in_reverse) const { return in_reverse ? T_map_taught_.size() - 1 : 0; }

  /// True pose of a vehicle on the map, by the taught pose of this index.
  Pose2 on_map(const Pose2& T_world_vehicle, std::size_t taught) const;
  /// Pose in the world of a pose on the map, by the taught pose of this index.
  Pose2 in_world(const Pose2& T_map_place, std::size_t taught) const;
  /// The same by the nearest taught pose of all.
  Pose2 in_world(const Pose2& T_map_place) const;

  const std::vector<Pose2>& T_map_taught() const { return T_map_taught_; }
  const std::vector<Pose2>& T_world_taught() const { return T_world_taught_; }

 private:
  std::vector<Pose2> T_map_taught_, T_world_taught_;
  std::vector<double> travelled_m_;  ///< distance travelled to each taught pose
};

}  // namespace aisle
