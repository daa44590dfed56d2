#include "section_course.hpp"

#include <utility>

#include "aisle/guidance/hand_driver.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/simulation/scripted_operator.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Collects what is learned from.
class SectionLessonRecord final : public MissionRecord {
 public:
  SectionLessonRecord(const FloorEdgeParams& params, const SimulatedVehicle& vehicle)
      : collector(params, vehicle.description()) {}

  Result<Observation> keep(Observation observation) override {
    collector.add(observation);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  SectionTripCollector collector;
};

}  // namespace

Result<SectionCourse> teach_sections(const SimulationSetting& setting, const SectionLessonParams& params,
                                     std::uint64_t seed, Progress& progress) {
  const auto start = start_in(setting);
  if (!start) return start.problems();
  const VehicleDescription& vehicle = setting.vehicle.description;
  ScriptedOperator person(setting.world, vehicle, {}, seed);
  SimulatedVehicle taught(setting.world, setting.vehicle, {}, {.seed = seed, .T_world_start = *start},
                          &person);
  HandDriver driver({});
  SectionLessonRecord record(params.floor_edges, taught);
  const auto end = run_mission(taught, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived()) return Problem{{}, "the person did not get through"};
  auto lesson = learn_sections(record.collector.cycles, vehicle, "route", params);
  if (!lesson) return lesson.problems();
  const Pose2 T_world_map = *start * lesson->driven.T_route_vehicle.front().inverse();
  return SectionCourse{std::move(*lesson), T_world_map};
}

}  // namespace aisle
