#include "aisle/commands/simulation_setting.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/commands/plan_reading.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/worlds/scenario_yaml.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"

namespace aisle {
namespace {

/// A scenario's places are only valid in its own world. A kidnapped vehicle must fit where it is put down.
Problems check_scenario(const std::string& file, const SimulationSetting& setting) {
  Problems problems;
  if (const std::string& needed = setting.scenario.world; !needed.empty() && needed != setting.world.name) {
    problems.push_back(
        {{file, 0, "world"},
         fmt::format("the scenario is for the world '{}', this is '{}'", needed, setting.world.name)});
  }
  for (std::size_t i = 0; i < setting.scenario.events.size(); ++i) {
    const auto* lifted = std::get_if<Lifted>(&setting.scenario.events[i].fault);
    if (lifted == nullptr ||
        fits(setting.world, setting.vehicle.description.footprint, lifted->T_world_vehicle))
      continue;
    problems.push_back({{file, 0, fmt::format("events[{}].lift", i)}, "the vehicle does not fit there"});
  }
  return problems;
}

Result<World> read_world_or_plan(const std::filesystem::path& file, double plan_pixel_m,
                                 std::vector<std::string>& warnings) {
  if (!is_plan(file)) return read_world(file);
  const PlanOptions plan{.plan = file, .resolution_m = plan_pixel_m};
  SilentProgress silent;
  Console console{silent, [&](const std::string& warning) { warnings.push_back(warning); }};
  auto world = world_of_plan(plan, console);
  if (!world) return world;
  return with_tour(std::move(*world), {}, console).world;
}

}  // namespace

Result<SimulationSetting> read_setting(const std::string& world, const std::string& vehicle,
                                       const std::string& scenario, double plan_pixel_m) {
  SimulationSetting setting;
  if (!world.empty()) {
    auto file = shipped_or_own("worlds", world);
    if (!file) return file.problems();
    setting.world_file = std::move(*file);
    auto read = read_world_or_plan(setting.world_file, plan_pixel_m, setting.warnings);
    if (!read) return read.problems();
    setting.world = std::move(*read);
  }
  auto model = read_shipped_or_own("vehicles", vehicle, read_vehicle);
  if (!model) return model.problems();
  setting.vehicle = std::move(*model);
  if (scenario.empty()) return setting;
  auto faults = read_shipped_or_own("scenarios", scenario, read_scenario);
  if (!faults) return faults.problems();
  setting.scenario = std::move(*faults);
  if (Problems problems = check_scenario(scenario, setting); !problems.empty()) return problems;
  return setting;
}

Result<Pose2> start_in(const SimulationSetting& setting) {
  const std::string file = setting.world_file.string();
  const auto start = start_pose(setting.world);
  if (!start) return Problem{{file, 0, "start"}, "is missing, and there is no tour"};
  if (!fits(setting.world, setting.vehicle.description.footprint, *start)) {
    return Problem{{file, 0, setting.world.start ? "start" : "tour"}, "the vehicle does not fit there"};
  }
  return *start;
}

SimulatedVehicle vehicle_in(const SimulationSetting& setting, const Pose2& T_world_start,
                            std::uint64_t seed) {
  return {setting.world, setting.vehicle, setting.scenario, {.seed = seed, .T_world_start = T_world_start}};
}

}  // namespace aisle
