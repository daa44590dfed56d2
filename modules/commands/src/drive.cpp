#include "aisle/commands/drive.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/simulation_setting.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {
namespace {

/// Everything a drive needs, read and checked.
struct Drive {
  DriveParams params;
  SimulationSetting setting;
  Pose2 T_world_start;
};

Result<Drive> read_drive(const DriveOptions& options) {
  Drive drive;
  FieldList fields = fields_of(drive.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto setting = read_setting(options.world, options.vehicle, options.scenario);
  if (!setting) return setting.problems();
  drive.setting = std::move(*setting);
  if (!options.camera.empty()) {
    std::erase_if(drive.setting.vehicle.description.cameras,
                  [&](const CameraDescription& camera) { return camera.name != options.camera; });
    if (drive.setting.vehicle.description.cameras.empty())
      return Problem{{options.vehicle, 0, "cameras"}, "there is no camera " + options.camera};
  }
  const auto start = options.T_world_start ? Result<Pose2>(*options.T_world_start) : start_in(drive.setting);
  if (!start) return start.problems();
  drive.T_world_start = *start;
  if (!options.keys && drive.setting.world.tour.size() < 2) {
    return Problem{{drive.setting.world_file.string(), 0, "tour"},
                   "needs at least two waypoints to be followed"};
  }
  return drive;
}

SessionOrigin origin_of(const DriveOptions& options, const Drive& drive) {
  return {.navigator = "hand",
          .parameters = changed_parameters(drive.params.limits),
          .seed = options.seed,
          .building = {},
          .route = options.route};
}

Outcome outcome_of(const DriveOptions& options, const Drive& drive, const MissionResult& result,
                   const MissionRecorder& record, double worked_s) {
  const MissionEnd& end = result.end;
  Outcome outcome{.verb = "drive", .ok = end.arrived && result.is_unharmed()};
  const double factor = record.stamp_s() / std::max(worked_s, 1e-6);
  outcome.figures = known_figures({{"simulated", result.is_simulated()},
                                   {"seed", options.seed},
                                   {"vehicle", drive.setting.vehicle.description.name},
                                   {"cycles", end.cycles},
                                   {"duration_s", rounded(record.stamp_s(), 3)},
                                   {"distance_m", rounded(result.distance_m(), 3)},
                                   {"pictures", record.images()},
                                   {"collisions", if_known(result.collisions())},
                                   {"state", end.state},
                                   {"why", end.why},
                                   {"real_time_factor", rounded(factor, 1)}});
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format(
      "{}drive through {} with {}: {:.1f} m in {:.1f} s{}; {}{}{}\n"
      "{} images; {:.1f} times as fast as real time{}\n",
      result.is_simulated() ? "simulated " : "", drive.setting.world.name,
      drive.setting.vehicle.description.name, result.distance_m(), record.stamp_s(), collisions_text(result),
      end.state, end.why.empty() ? "" : ": ", end.why, record.images(), factor,
      options.out.empty() ? "" : "; session in " + options.out.string());
  return outcome;
}

Result<std::unique_ptr<Operator>> operator_of(const DriveOptions& options, const Drive& drive) {
  const VehicleDescription& vehicle = drive.setting.vehicle.description;
  if (options.keys) return options.keys(vehicle, drive.params.keys);
  return std::unique_ptr<Operator>(
      std::make_unique<ScriptedOperator>(drive.setting.world, vehicle, drive.params.person, options.seed));
}

}  // namespace

Outcome drive_parameters() {
  DriveParams params;
  return parameter_listing("drive", fields_of(params));
}

Result<Outcome> run_drive(const DriveOptions& options, Console& console) {
  const auto drive = read_drive(options);
  if (!drive) return drive.problems();
  const auto person = operator_of(options, *drive);
  if (!person) return person.problems();
  SimulatedVehicle vehicle(
      drive->setting.world, drive->setting.vehicle, drive->setting.scenario,
      {.seed = options.seed, .T_world_start = drive->T_world_start, .takes_images = options.takes_images},
      person->get());
  auto session = open_session(options.out, options.force, options.storage, vehicle, &vehicle,
                              origin_of(options, *drive), console.watcher);
  if (!session) return session.problems();
  HandDriver driver(drive->params.limits);
  MissionRecorder record(*session, vehicle, &vehicle);
  MissionResult result;
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  if (Problems problems = drive_mission(vehicle, &vehicle, driver, record, console.progress, result);
      !problems.empty())
    return problems;
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;

  Outcome outcome = outcome_of(options, *drive, result, record, clock.now_s() - begun_s);
  if (const auto* scripted = dynamic_cast<const ScriptedOperator*>(person->get())) {
    outcome.figures["route_share"] = rounded(scripted->share_done(), 3);
    if (!scripted->has_arrived()) {
      outcome.text += fmt::format("not arrived: {:.0f} % of the route\n", 100 * scripted->share_done());
    }
  }
  return outcome;
}

}  // namespace aisle
