#pragma once
/// How well a mission localised itself and followed its path. No navigator ever sees any of this.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/control/path_progress.hpp"
#include "aisle/evaluation/error_figure.hpp"
#include "aisle/evaluation/map_truth.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/missions/landmarks/landmark_mission.hpp"

namespace aisle {

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
