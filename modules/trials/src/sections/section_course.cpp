#include "sections/section_course.hpp"

#include <utility>
#include <vector>

#include "aisle/commands/set_down.hpp"
#include "aisle/guidance/hand_driver.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/simulation/operators/scripted_operator.hpp"

namespace aisle {
namespace {

/// Records what is learned from.
class SectionRunRecord final : public MissionRecord {
 public:
  SectionRunRecord(const FloorEdgeParams& params, const VehicleDescription& vehicle)
      : collector(params, vehicle) {}

  Result<Observation> keep(Observation observation) override {
    collector.add(observation);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  SectionRunCollector collector;
};

/// A scripted person drives the world's tour once.
Result<DrivenList> teach_once(const SimulationSetting& setting, const Pose2& T_world_start,
                              const SectionLearnerParams& params, std::uint64_t seed, Progress& progress) {
  const VehicleDescription& vehicle = setting.vehicle.description;
  ScriptedOperator person(setting.world, vehicle, {}, seed);
  SimulatedVehicle taught(setting.world, setting.vehicle, {}, {.seed = seed, .T_world_start = T_world_start},
                          &person);
  HandDriver driver({});
  SectionRunRecord record(params.floor_edges, vehicle);
  const auto end = run_mission(taught, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived()) return Problem{{}, "the person did not get through"};
  return record_drive(record.collector.cycles, vehicle, params.learning);
}

}  // namespace

Result<SectionCourse> teach_sections(const SimulationSetting& setting, const SectionLearnerParams& params,
                                     std::uint64_t seed, int teachings, Progress& progress) {
  constexpr std::uint64_t kSeedStep = 1'000'000;  // from one taught run to the next
  const auto start = start_in(setting);
  if (!start) return start.problems();
  std::vector<DrivenList> drives;
  for (int i = 0; i < teachings; ++i) {
    auto drive = teach_once(setting, *start, params, seed + kSeedStep * static_cast<unsigned>(i), progress);
    if (!drive) return drive.problems();
    drives.push_back(std::move(*drive));
  }
  auto learned = learn_sections(drives, "route", params.learning);
  if (!learned) return learned.problems();
  if (const auto why = gets_lost(*learned, params.learning)) return Problem{{}, *why};
  const Pose2 T_world_map = *start * learned->driven.T_route_vehicle.front().inverse();
  return SectionCourse{std::move(*learned), T_world_map};
}

Result<JudgedSectionMission> drive_there_and_back(const SimulationSetting& setting,
                                                  const SectionNavigatorParams& params,
                                                  const SectionCourse& course, std::uint64_t seed,
                                                  bool keeps_images, Progress& progress) {
  const VehicleDescription& vehicle = setting.vehicle.description;
  const SectionLearningResult& learned = course.learned;
  const SectionList& sections = learned.building.routes.front().sections;
  SectionNavigator navigator(params, vehicle, vehicle.cameras.front().name, sections,
                             guided_path(sections, learned.driven.T_route_start, SectionRun::kThereAndBack));
  const Pose2 T_map_start = navigator.path().at(0).T_map_path;
  const Pose2 T_world_start = set_down_on_route(setting, course.T_world_map * T_map_start, seed);
  SimulatedVehicle driven = vehicle_in(setting, T_world_start, seed);
  std::optional<SessionRecord> no_session;
  auto mission = drive_section_mission(driven, &driven, navigator, keeps_images, no_session, progress);
  if (!mission) return mission.problems();
  return judged(std::move(*mission), navigator, {setting.world, course.T_world_map, T_world_start});
}

}  // namespace aisle
