#include "landmarks/landmark_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rounded.hpp"
#include "statistics.hpp"

namespace aisle {
namespace {

constexpr double kWrong_m = 0.5;
constexpr double kWrongMax_s = 3;
constexpr double kTaughtAhead_m = 1.0;  // path length searched for the next taught pose along a path
constexpr double kNearer_m = 0.01;      // a taught pose must be nearer by this much to replace an earlier one
constexpr double kFoundOff_m = 1;       // greatest distance from its path at which a lost vehicle continues
constexpr double kNear_m = 0.5;         // window along the path for its point nearest to the vehicle

}  // namespace

MapTruth::MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught)
    : T_map_taught_(std::move(T_map_taught)), T_world_taught_(std::move(T_world_taught)) {
  for (std::size_t i = 0; i < T_map_taught_.size(); ++i) {
    const double step_m = i == 0 ? 0 : between(T_map_taught_[i - 1], T_map_taught_[i]).position().norm();
    travelled_m_.push_back(i == 0 ? 0 : travelled_m_.back() + step_m);
  }
}

Pose2 MapTruth::on_map(const Pose2& T_world_vehicle, std::size_t taught) const {
  return T_map_taught_[taught] * between(T_world_taught_[taught], T_world_vehicle);
}

Pose2 MapTruth::in_world(const Pose2& T_map_place, std::size_t taught) const {
  return T_world_taught_[taught] * between(T_map_taught_[taught], T_map_place);
}

Pose2 MapTruth::in_world(const Pose2& T_map_place) const {
  return in_world(T_map_place, nearest(T_map_place));
}

std::size_t MapTruth::nearest(const Pose2& T_map_place) const {
  const auto distance = [&](const Pose2& T) { return (T.position() - T_map_place.position()).squaredNorm(); };
  const auto found =
      std::min_element(T_map_taught_.begin(), T_map_taught_.end(),
                       [&](const Pose2& a, const Pose2& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(found - T_map_taught_.begin());
}

std::vector<std::size_t> MapTruth::along(const Path& path, bool in_reverse) const {
  const std::size_t count = T_map_taught_.size();
  const auto in_order = [&](std::size_t i) { return in_reverse ? count - 1 - i : i; };
  const auto steps = static_cast<std::size_t>(path.length_m() / kAlongStep_m);
  std::vector<std::size_t> taught;
  std::size_t last = 0;
  for (std::size_t step = 0; step <= steps; ++step) {
    const Vec2 p_map = path.at(static_cast<double>(step) * kAlongStep_m).T_map_path.position();
    const auto distance = [&](std::size_t i) {
      return (T_map_taught_[in_order(i)].position() - p_map).norm();
    };
    const double from_m = travelled_m_[in_order(last)];
    for (std::size_t i = last + 1; i < count && std::abs(travelled_m_[in_order(i)] - from_m) < kTaughtAhead_m;
         ++i)
      if (distance(i) < distance(last) - kNearer_m) last = i;
    taught.push_back(in_order(last));
  }
  return taught;
}

void ErrorFigure::add(double error) {
  sum_of_squares_ += error * error;
  worst_ = std::max(worst_, std::abs(error));
  ++count_;
}

double ErrorFigure::rms() const {
  return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
}

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
