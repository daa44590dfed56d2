#pragma once
/// How well a mission localised itself and followed its path. No navigator ever sees any of this.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/control/path_progress.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "landmarks/landmark_mission.hpp"

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
  ErrorFigure across_m, along_m, heading_rad;  ///< of the pose, while the navigator was sure of it
  ErrorFigure tracking_m;                      ///< cross-track error of the true pose, in the same cycles
  /// Was ever off by more than half a metre for over three seconds and yet sure. The three seconds are for a
  /// kidnapped vehicle, which cannot know it at once.
  bool wrong_confident = false;
  bool knew_place_at_end = false;  ///< not lost, and off by at most half a metre
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
  PathProgress progress_;            ///< of the estimated pose
  bool is_lost_ = false;
  std::optional<double> wrong_since_s_;  ///< and sure
  MissionErrors errors_;
};

/// A mission and, where the truth is known, its errors.
struct JudgedLandmarkMission {
  LandmarkMissionResult mission;
  std::optional<MissionErrors> errors;
};

/// Judges a mission along `path`.
/// @param in_reverse  the path is a route's return path
JudgedLandmarkMission judged(LandmarkMissionResult mission, const MapTruth& truth, const Path& path,
                             bool in_reverse);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const JudgedLandmarkMission& judged);

}  // namespace aisle
