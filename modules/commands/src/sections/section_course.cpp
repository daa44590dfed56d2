#include "sections/section_course.hpp"

#include <utility>
#include <vector>

#include "aisle/guidance/hand_driver.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/simulation/operators/scripted_operator.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Records what is learned from.
class SectionRunRecord final : public MissionRecord {
 public:
  SectionRunRecord(const FloorEdgeParams& params, const SimulatedVehicle& vehicle)
      : collector(params, vehicle.description()) {}

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
  SectionRunRecord record(params.floor_edges, taught);
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

}  // namespace aisle
