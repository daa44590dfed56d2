#include "exploration/guide_mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/cell_index.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "simulated_record.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

constexpr double kCoverEvery_m = 0.1;
constexpr double kCoverWithin_m = 0.5;
constexpr double kSetDownSigma_m = 0.05;
constexpr double kSetDownSigma_rad = 1 * kDegree;
constexpr std::uint64_t kSetDownStream = 0x6d1de;  // separates this random stream from the vehicle's

ViewMatch wall_match(const WallLocaliser& localiser) {
  const double seen_m = localiser.seen_m(), fitting_m = localiser.fitting_m();
  return {seen_m > 0 ? fitting_m / seen_m : 0, fmt::format("{:.1f} of {:.1f} m of wall", fitting_m, seen_m)};
}

class GuideMissionRecord final : public SimulatedRecord {
 public:
  GuideMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                     const GuideNavigator& navigator, GuideMissionResult& result)
      : SimulatedRecord(session, vehicle), vehicle_(vehicle), navigator_(navigator), result_(result) {}

  using SimulatedRecord::keep;

  Problems keep(const Decision& decision) override {
    result_.T_map_vehicle.push_back(navigator_.T_map_vehicle());
    result_.T_world_vehicle.push_back(vehicle_.truth().T_world_vehicle);
    show_pose({navigator_.T_map_vehicle()});
    show_plan(navigator_.path());
    show_match(wall_match(navigator_.localiser()));
    show_floor(navigator_.floor().grid());
    return SimulatedRecord::keep(decision);
  }

 private:
  const SimulatedVehicle& vehicle_;
  const GuideNavigator& navigator_;
  GuideMissionResult& result_;
};

/// Random initial pose, as of a vehicle that is put down by hand; the exact pose if the random one is
/// occupied.
Pose2 set_down_about(const SimulationSetting& setting, const Pose2& T_world_start, std::uint64_t seed) {
  Random random(seed ^ kSetDownStream);
  const Pose2 off{random.normal(kSetDownSigma_m), random.normal(kSetDownSigma_m),
                  random.normal(kSetDownSigma_rad)};
  const Pose2 T_world_vehicle = T_world_start * off;
  return fits(setting.world, setting.vehicle.description.footprint, T_world_vehicle) ? T_world_vehicle
                                                                                     : T_world_start;
}

}  // namespace

Result<GuideMissionResult> drive_guide_mission(const SimulationSetting& setting, GuideDriver& driver,
                                               const Pose2& T_world_start, std::uint64_t seed,
                                               std::optional<SessionRecord>& session, Progress& progress) {
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = seed, .T_world_start = set_down_about(setting, T_world_start, seed)});
  GuideMissionResult result;
  TimedNavigator timed(driver, result.cycle_s);
  GuideMissionRecord record(session, vehicle, driver.navigator(), result);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  result.end = std::move(*end);
  result.collisions = vehicle.truth().collisions;
  result.distance_m = vehicle.truth().path_m;
  return result;
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
