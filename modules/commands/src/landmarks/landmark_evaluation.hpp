#pragma once
/// How well a simulated mission knew where it was and kept to its path. Nothing of this is ever seen by a
/// navigator.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/control/path_progress.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"

namespace aisle {

/// How a learned map lies in the world, given by the run that taught it: the map's drift over a long path is
/// not an error of driving by it. Where the vehicle is on the map is judged against the nearest pose of that
/// run.
class MapTruth {
 public:
  MapTruth() = default;
  /// The two are of the same moments; not empty.
  MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught);

  bool empty() const { return T_map_taught_.empty(); }

  /// The taught pose next to a place.
  std::size_t nearest(const Pose2& T_map_place) const;
  /// The taught poses next to a route's path, or to its return path, every kAlongStep_m of it from its start:
  /// one after the other as they were taught, so that a path that comes by the same place again is not mixed
  /// up.
  std::vector<std::size_t> along(const Path& path, bool in_reverse) const;
  static constexpr double kAlongStep_m = 0.05;
  /// The taught pose from which a route, or its return path, begins.
  std::size_t start(bool in_reverse) const { return in_reverse ? T_map_taught_.size() - 1 : 0; }

  /// Where a vehicle really is on the map, by the taught pose next to it.
  Pose2 on_map(const Pose2& T_world_vehicle, std::size_t taught) const;
  /// Where in the world a place of the map is, by the taught pose next to it.
  Pose2 in_world(const Pose2& T_map_place, std::size_t taught) const;
  /// The same by the nearest taught pose of all.
  Pose2 in_world(const Pose2& T_map_place) const;

  const std::vector<Pose2>& T_map_taught() const { return T_map_taught_; }
  const std::vector<Pose2>& T_world_taught() const { return T_world_taught_; }

 private:
  std::vector<Pose2> T_map_taught_, T_world_taught_;
  std::vector<double> travelled_m_;  ///< to each of them
};

/// Root mean square and greatest magnitude of an error.
class ErrorFigure {
 public:
  void add(double error);
  double rms() const;
  double worst() const { return worst_; }
  std::size_t count() const { return count_; }

 private:
  double sum_of_squares_ = 0;
  double worst_ = 0;
  std::size_t count_ = 0;
};

/// Errors of one mission.
struct MissionErrors {
  ErrorFigure across_m, along_m, heading_rad;  ///< of the pose, while it was sure
  ErrorFigure tracking_m;                      ///< of the vehicle against its path
  /// Ever off by more than half a metre for longer than three seconds on end and yet sure: a vehicle that was
  /// lifted cannot know it at once.
  bool wrong_confident = false;
  bool knew_place_at_end = false;  ///< was not lost, and not off by more than half a metre
};

/// Judges a mission, cycle by cycle.
class MissionJudge {
 public:
  /// Truth and path must outlive the judge.
  /// @param in_reverse  the path is a route's return path
  MissionJudge(const MapTruth& truth, const Path& path, bool in_reverse)
      : truth_(truth), path_(path), taught_(truth.along(path, in_reverse)), progress_(path) {}

  /// One cycle, which ends at `stamp_s`.
  void add(double stamp_s, const LandmarkFix& fix, const Pose2& T_world_vehicle);
  const MissionErrors& errors() const { return errors_; }

 private:
  void follow(const LandmarkFix& fix);

  const MapTruth& truth_;
  const Path& path_;
  std::vector<std::size_t> taught_;  ///< along the path
  PathProgress progress_;            ///< of where the vehicle thinks it is
  bool is_lost_ = false;
  std::optional<double> wrong_since_s_;  ///< and sure
  MissionErrors errors_;
};

}  // namespace aisle
