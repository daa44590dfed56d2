#include "aisle/commands/drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/mission_result.hpp"
#include "operated_vehicle.hpp"

namespace aisle {
namespace {

/// Everything a drive needs, read and checked.
struct Drive {
  DriveParams params;
  std::unique_ptr<DrivenVehicle> driven;
  std::unique_ptr<Operator> person;  ///< null: nobody at the keys
};

/// What is driven and who drives, of a simulated vehicle.
Problems prepare_simulation(const DriveOptions& options, Drive& drive) {
  auto read = read_setting(options.world, options.vehicle, options.scenario);
  if (!read) return read.problems();
  drive.driven = DrivenVehicle::in(std::move(*read), options.seed);
  SimulationSetting& setting = *drive.driven->setting();
  VehicleDescription& vehicle = setting.vehicle.description;
  if (!options.camera.empty()) {
    std::erase_if(vehicle.cameras,
                  [&](const CameraDescription& camera) { return camera.name != options.camera; });
    if (vehicle.cameras.empty())
      return {{{options.vehicle, 0, "cameras"}, "there is no camera " + options.camera}};
  }
  const auto start = options.T_world_start ? Result<Pose2>(*options.T_world_start) : start_in(setting);
  if (!start) return start.problems();
  if (options.keys) {
    auto person = options.keys(vehicle, drive.params.keys);
    if (!person) return person.problems();
    drive.person = std::move(*person);
  } else if (setting.world.tour.size() < 2) {
    return {{{setting.world_file.string(), 0, "tour"}, "needs at least two waypoints to be followed"}};
  } else {
    drive.person =
        std::make_unique<ScriptedOperator>(setting.world, vehicle, drive.params.person, options.seed);
  }
  drive.driven->set_down(*start, drive.person.get(), options.takes_images);
  return {};
}

/// The part of the connection by which the robot is driven: its cameras, where it has some.
Result<Connection> driven_connection(const DriveOptions& options) {
  auto read = read_connection(options.connection);
  if (!read) return read.problems();
  const std::string joystick = read->joystick.topic;
  const DrivenBy sensors = read->cameras.empty() ? DrivenBy::kScanner : DrivenBy::kCameras;
  auto connection = reduced_to(sensors, std::move(*read));
  if (!connection) return connection.problems();
  if (!options.camera.empty()) {
    std::erase_if(connection->cameras,
                  [&](const ConnectedCamera& camera) { return camera.name != options.camera; });
    if (connection->cameras.empty())
      return Problem{{connection->file, 0, "cameras"}, "there is no camera " + options.camera};
  }
  if (options.by_joystick) connection->joystick.topic = joystick;
  if (options.by_joystick && joystick.empty())
    return Problem{{connection->file, 0, "joystick.topic"}, "is empty, but a joystick should drive"};
  if (options.only_listens) {
    connection->commands.topic.clear();
  } else if (connection->commands.topic.empty()) {
    return Problem{{connection->file, 0, "command.topic"}, "is empty, but this sends commands"};
  }
  return connection;
}

Problems prepare_robot(const DriveOptions& options, Drive& drive, Console& console) {
  auto connection = driven_connection(options);
  if (!connection) return connection.problems();
  auto robot = connect_robot(std::move(*connection), console);
  if (!robot) return robot.problems();
  drive.driven = DrivenVehicle::over(std::move(*robot));
  if (options.unfit) {
    if (Problems problems = options.unfit(drive.driven->description()); !problems.empty())
      return at_file(std::move(problems), options.vehicle_file());
  }
  if (!options.keys) return {};
  auto person = options.keys(drive.driven->description(), drive.params.keys);
  if (!person) return person.problems();
  drive.person = std::move(*person);
  return {};
}

Result<Drive> read_drive(const DriveOptions& options, Console& console) {
  Drive drive;
  FieldList fields = fields_of(drive.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  Problems problems = options.connection.empty() ? prepare_simulation(options, drive)
                                                 : prepare_robot(options, drive, console);
  if (!problems.empty()) return problems;
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
  const std::string& vehicle = drive.driven->description().name;
  const SimulationSetting* const setting = drive.driven->setting();
  Outcome outcome{.verb = "drive", .ok = end.arrived && result.is_unharmed()};
  const double factor = record.stamp_s() / std::max(worked_s, 1e-6);
  outcome.figures = known_figures({{"vehicle", vehicle},
                                   {"cycles", end.cycles},
                                   {"duration_s", rounded(record.stamp_s(), 3)},
                                   {"distance_m", rounded(result.distance_m(), 3)},
                                   {"pictures", record.images()},
                                   {"collisions", if_known(result.collisions())},
                                   {"state", end.state},
                                   {"why", end.why},
                                   {"real_time_factor", rounded(factor, 1)}});
  drive.driven->add_to(outcome.figures);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format(
      "{}drive {}with {}: {:.1f} m in {:.1f} s{}; {}{}{}\n"
      "{} images; {:.1f} times as fast as real time{}\n",
      result.is_simulated() ? "simulated " : "",
      setting == nullptr ? std::string() : fmt::format("through {} ", setting->world.name), vehicle,
      result.distance_m(), record.stamp_s(), collisions_text(result), end.state, end.why.empty() ? "" : ": ",
      end.why, record.images(), factor, options.out.empty() ? "" : "; session in " + options.out.string());
  return outcome;
}

}  // namespace

Outcome drive_parameters() {
  DriveParams params;
  return parameter_listing("drive", fields_of(params));
}

Result<Outcome> run_drive(const DriveOptions& options, Console& console) {
  auto drive = read_drive(options, console);
  if (!drive) return drive.problems();
  DrivenVehicle& driven = *drive->driven;
  const bool is_robot = driven.setting() == nullptr;
  OperatedVehicle vehicle(driven.vehicle(), is_robot ? drive->person.get() : nullptr);
  auto session = open_session(options.out, options.force, options.storage, vehicle, driven.truth(),
                              origin_of(options, *drive), driven.watcher(console));
  if (!session) return session.problems();
  HandDriver driver(drive->params.limits);
  MissionRecorder record(*session, vehicle, driven.truth());
  MissionResult result;
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  if (Problems problems = drive_mission(vehicle, driven.truth(), driver, record, console.progress, result);
      !problems.empty())
    return problems;
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;

  Outcome outcome = outcome_of(options, *drive, result, record, clock.now_s() - begun_s);
  if (const auto* scripted = dynamic_cast<const ScriptedOperator*>(drive->person.get())) {
    outcome.figures["route_share"] = rounded(scripted->share_done(), 3);
    if (!scripted->has_arrived()) {
      outcome.text += fmt::format("not arrived: {:.0f} % of the route\n", 100 * scripted->share_done());
    }
  }
  return outcome;
}

}  // namespace aisle
