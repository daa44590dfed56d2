#include "aisle/missions/exploration/guide_mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kCoverEvery_m = 0.1;
constexpr double kCoverWithin_m = 0.5;

ViewMatch wall_match(const WallLocaliser& localiser) {
  const double seen_m = localiser.seen_m(), fitting_m = localiser.fitting_m();
  return {seen_m > 0 ? fitting_m / seen_m : 0, fmt::format("{:.1f} of {:.1f} m of wall", fitting_m, seen_m)};
}

/// @tparam Driver  GuideDriver or GoalFollower
template <class Driver>
class GuideMissionRecorder final : public MissionRecorder {
 public:
  GuideMissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle,
                       const TruthSource* truth, const Driver& driver, GuideMissionResult& result)
      : MissionRecorder(session, vehicle, truth), driver_(driver), result_(result) {}

  using MissionRecorder::keep;

  Problems keep(const Decision& decision) override {
    if (Problems problems = record_goals(); !problems.empty()) return problems;
    if (driver_.is_finding()) return MissionRecorder::keep(decision);
    const GuideNavigator& navigator = driver_.navigator();
    result_.T_map_vehicle.push_back(navigator.T_map_vehicle());
    if (const Pose2* T_world = T_world_vehicle()) result_.T_world_vehicle.push_back(*T_world);
    show_pose({navigator.T_map_vehicle()});
    show_plan(navigator.path());
    show_match(wall_match(navigator.localiser()));
    show_floor(navigator.floor().grid());
    return MissionRecorder::keep(decision);
  }

 private:
  Problems record_goals() {
    if constexpr (std::is_same_v<Driver, GuideDriver>) {
      if (has_session()) return keep_goals(goals_json(driver_.goal(), driver_.navigator().places_reached()));
    }
    return {};
  }

  const Driver& driver_;
  GuideMissionResult& result_;
};

/// @param driver  GuideDriver or GoalFollower
Result<GuideMissionResult> driven(Vehicle& vehicle, const TruthSource* truth, auto& driver,
                                  std::optional<SessionRecord>& session, Progress& progress) {
  GuideMissionResult result;
  GuideMissionRecorder record(session, vehicle, truth, driver, result);
  if (Problems problems = drive_mission(vehicle, truth, driver, record, progress, result); !problems.empty())
    return problems;
  return result;
}

}  // namespace

Result<GuideMissionResult> drive_guide_mission(Vehicle& vehicle, const TruthSource* truth,
                                               GuideDriver& driver, std::optional<SessionRecord>& session,
                                               Progress& progress) {
  return driven(vehicle, truth, driver, session, progress);
}

Result<GuideMissionResult> follow_goals(Vehicle& vehicle, GoalFollower& follower,
                                        std::optional<SessionRecord>& session, Progress& progress) {
  return driven(vehicle, nullptr, follower, session, progress);
}

double graph_coverage(const CorridorGraph& graph, const std::vector<Pose2>& T_map_vehicle,
                      const Footprint& footprint) {
  std::vector<Segment2> lines;
  CellIndex index;
  for (const Pose2& T : T_map_vehicle) {
    const Segment2 line{T * Vec2(-footprint.rear_m, 0), T * Vec2(footprint.front_m, 0)};
    index.add(line, static_cast<int>(lines.size()));
    lines.push_back(line);
  }
  std::size_t points = 0, covered = 0;
  std::vector<int> near;
  for (const Corridor& corridor : graph.corridors) {
    const int steps = static_cast<int>(corridor.length_m() / kCoverEvery_m);
    for (int k = 0; k <= steps; ++k) {
      const Vec2 p = corridor.at(k * kCoverEvery_m);
      index.query(p, p, kCoverWithin_m, near);
      const bool is_covered = std::any_of(near.begin(), near.end(), [&](int i) {
        return lines[static_cast<std::size_t>(i)].distance(p) <= kCoverWithin_m;
      });
      ++points;
      covered += is_covered ? 1U : 0U;
    }
  }
  return points == 0 ? 1 : static_cast<double>(covered) / static_cast<double>(points);
}

}  // namespace aisle
