#include "aisle/missions/landmarks/landmark_mission.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "aisle/report/landmark_picture.hpp"

namespace aisle {
namespace {

ViewMatch landmark_match(const LandmarkNavigator& navigator) {
  const LandmarkLocaliser& localiser = navigator.localiser();
  return {localiser.matched_share(),
          fmt::format("{} of {} lines", localiser.pairs().size(), navigator.sightings().size())};
}

/// Records the mission's session, and collects the mission's result.
class LandmarkMissionRecorder final : public MissionRecorder {
 public:
  LandmarkMissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle,
                          const TruthSource* truth, const LandmarkNavigator& navigator,
                          LandmarkMissionResult& result)
      : MissionRecorder(session, vehicle, truth), navigator_(navigator), result_(result) {}

  Result<Observation> keep(Observation observation) override {
    auto kept = MissionRecorder::keep(std::move(observation));
    if (kept) cycle_ = {.stamp_s = kept->stamp_s, .odometry = kept->odometry, .sightings = {}};
    return kept;
  }

  Problems keep(const Decision& decision) override {
    const LandmarkFix fix = navigator_.fix();
    result_.fixes.push_back(fix);
    if (const Pose2* T_world = T_world_vehicle()) result_.T_world_vehicle.push_back(*T_world);
    show_pose(fix.T_map_vehicle);
    if (is_watched() && !image_camera().empty()) {
      show_match(landmark_match(navigator_));
      show_overlay(overlay_of(navigator_, vehicle().description(), image_camera()));
    }
    if (decision.state == "lost" && state_ != "lost") ++result_.lost_count;
    state_ = decision.state;
    cycle_.sightings = navigator_.sightings();
    result_.cycles.push_back(cycle_);
    return MissionRecorder::keep(decision);
  }

 private:
  const LandmarkNavigator& navigator_;
  LandmarkMissionResult& result_;
  LandmarkCycle cycle_;
  std::string state_;
};

}  // namespace

Result<LandmarkMissionResult> drive_landmark_mission(Vehicle& vehicle, const TruthSource* truth,
                                                     LandmarkDriver& driver,
                                                     std::optional<SessionRecord>& session,
                                                     Progress& progress) {
  LandmarkMissionResult result;
  result.T_map_start = driver.path().at(0).T_map_path;
  LandmarkMissionRecorder record(session, vehicle, truth, driver.navigator(), result);
  if (Problems problems = drive_mission(vehicle, truth, driver, record, progress, result); !problems.empty())
    return problems;
  return result;
}

std::string trace_picture(const Building& building, const LandmarkMissionResult& result,
                          const std::string& title) {
  std::vector<Pose2> T_map_driven;
  std::vector<Vec2> seen;
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    T_map_driven.push_back(result.fixes[i].T_map_vehicle.mean);
    for (const LandmarkSighting& sighting : result.cycles[i].sightings)
      seen.push_back(T_map_driven.back() * sighting.p_vehicle);
  }
  const std::vector<std::vector<Pose2>> driven{std::move(T_map_driven)};
  return svg(LandmarkPicture{.landmarks = building.landmarks,
                             .routes = building.routes,
                             .driven = driven,
                             .seen = seen,
                             .title = title});
}

}  // namespace aisle
