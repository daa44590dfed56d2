#include "aisle/evaluation/landmarks/landmark_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/missions/statistics.hpp"

namespace aisle {
namespace {

constexpr double kWrong_m = 0.5;
constexpr double kWrongMax_s = 3;
constexpr double kFoundOff_m = 1;  // greatest distance from its path at which a lost vehicle continues
constexpr double kNear_m = 0.5;    // window along the path for its point nearest to the vehicle

}  // namespace

/// A vehicle that was lost, and perhaps kidnapped, may have relocalised elsewhere on its path.
void MissionJudge::follow(const LandmarkFix& fix) {
  const Pose2& T_map_estimated = fix.T_map_vehicle.mean;
  if (is_lost_ && fix.is_sure) progress_.find(T_map_estimated, kFoundOff_m);
  is_lost_ = fix.is_lost;
  if (fix.is_sure) progress_.advance(T_map_estimated);
}

void MissionJudge::add(double stamp_s, const LandmarkFix& fix, const Pose2& T_world_vehicle) {
  follow(fix);
  const double along_m = progress_.point().along_m;
  const auto step = static_cast<std::size_t>(along_m / MapTruth::kAlongStep_m);
  const Pose2 T_map_true = truth_.on_map(T_world_vehicle, taught_[std::min(step, taught_.size() - 1)]);
  const PathPoint nearest = path_.nearest(T_map_true.position(), along_m - kNear_m, along_m + kNear_m);
  const Pose2 error = between(T_map_true, fix.T_map_vehicle.mean);
  errors_.knew_place_at_end = !fix.is_lost && error.position().norm() <= kWrong_m;
  if (!fix.is_sure || error.position().norm() <= kWrong_m) {
    wrong_since_s_.reset();
  } else {
    if (!wrong_since_s_) wrong_since_s_ = stamp_s;
    errors_.wrong_confident = errors_.wrong_confident || stamp_s - *wrong_since_s_ > kWrongMax_s;
  }
  if (!fix.is_sure) return;
  errors_.along_m.add(error.x);
  errors_.across_m.add(error.y);
  errors_.heading_rad.add(error.theta);
  errors_.tracking_m.add((T_map_true.position() - nearest.T_map_path.position()).norm());
}

JudgedLandmarkMission judged(LandmarkMissionResult mission, const MapTruth& truth, const Path& path,
                             bool in_reverse) {
  if (!mission.is_simulated()) return {std::move(mission), std::nullopt};
  MissionJudge judge(truth, path, in_reverse);
  for (std::size_t i = 0; i < mission.fixes.size(); ++i)
    judge.add(mission.cycles[i].stamp_s, mission.fixes[i], mission.T_world_vehicle[i]);
  return {std::move(mission), judge.errors()};
}

nlohmann::ordered_json figures_of(const JudgedLandmarkMission& judged) {
  const LandmarkMissionResult& mission = judged.mission;
  nlohmann::ordered_json localisation, tracking;
  if (judged.errors) {
    const MissionErrors& errors = *judged.errors;
    localisation = {{"across_rmse_m", rounded(errors.across_m.rms(), 4)},
                    {"along_rmse_m", rounded(errors.along_m.rms(), 4)},
                    {"heading_rmse_deg", rounded(to_degrees(errors.heading_rad.rms()), 3)},
                    {"wrong_confident", errors.wrong_confident},
                    {"knew_place_at_end", errors.knew_place_at_end}};
    tracking = {{"rmse_m", rounded(errors.tracking_m.rms(), 4)},
                {"max_m", rounded(errors.tracking_m.worst(), 4)}};
  }
  return known_figures({{"arrived", mission.end.arrived},
                        {"state", mission.end.state},
                        {"why", mission.end.why},
                        {"collisions", if_known(mission.collisions())},
                        {"lost_count", mission.lost_count},
                        {"distance_m", rounded(mission.distance_m(), 3)},
                        {"duration_s", rounded(mission.end.duration_s, 3)},
                        {"localisation", std::move(localisation)},
                        {"tracking", std::move(tracking)},
                        {"cycle_ms", cycle_figures(mission.cycle_s)}});
}

}  // namespace aisle
