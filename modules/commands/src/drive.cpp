#include "aisle/commands/drive.hpp"

#include <fmt/format.h>

#include <cmath>

#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/formats/scenario_yaml.hpp"
#include "aisle/formats/session_record.hpp"
#include "aisle/formats/vehicle_yaml.hpp"
#include "aisle/formats/world_yaml.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"
#include "changed_parameters.hpp"

namespace aisle {
namespace {

/// All that a drive is made of, read and checked.
struct Drive {
  DriveParams params;
  std::filesystem::path world_file;
  World world;
  VehicleModel vehicle;
  Scenario scenario;
  Pose2 T_world_start;
};

/// Keeps a simulated mission as a session, the truth beside it; without a session nothing.
class SimulatedRecord final : public MissionRecord {
 public:
  SimulatedRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle)
      : session_(session), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override {
    pictures_ += observation.pictures.size();
    if (!session_) return observation;
    const SimulatedTruth& truth = vehicle_.truth();
    auto kept = session_->keep(std::move(observation));
    if (!kept) return kept.problems();
    Problems problems = session_->keep_truth(truth.stamp_s, truth.T_world_vehicle);
    if (!problems.empty()) return problems;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    return session_ ? session_->keep(decision) : Problems{};
  }

  std::size_t pictures() const { return pictures_; }

 private:
  std::optional<SessionRecord>& session_;
  const SimulatedVehicle& vehicle_;
  std::size_t pictures_ = 0;
};

/// Every place where the vehicle is set down.
Problems check_places(const DriveOptions& options, const Drive& drive) {
  const Footprint& footprint = drive.vehicle.description.footprint;
  Problems problems;
  if (!fits(drive.world, footprint, drive.T_world_start)) {
    const std::string key = drive.world.start ? "start" : "tour";
    problems.push_back({{drive.world_file.string(), 0, key}, "the vehicle does not fit there"});
  }
  for (std::size_t i = 0; i < drive.scenario.events.size(); ++i) {
    const auto* lifted = std::get_if<Lifted>(&drive.scenario.events[i].fault);
    if (lifted == nullptr || fits(drive.world, footprint, lifted->T_world_vehicle)) continue;
    problems.push_back(
        {{options.scenario, 0, fmt::format("events[{}].lift", i)}, "the vehicle does not fit there"});
  }
  return problems;
}

Result<Drive> read_drive(const DriveOptions& options) {
  Drive drive;
  FieldList fields = fields_of(drive.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  drive.world_file = shipped_or_own("worlds", options.world);
  auto world = read_world(drive.world_file);
  if (!world) return world.problems();
  drive.world = std::move(*world);
  auto vehicle = read_vehicle(shipped_or_own("vehicles", options.vehicle));
  if (!vehicle) return vehicle.problems();
  drive.vehicle = std::move(*vehicle);
  if (!options.scenario.empty()) {
    auto scenario = read_scenario(shipped_or_own("scenarios", options.scenario));
    if (!scenario) return scenario.problems();
    drive.scenario = std::move(*scenario);
  }
  const auto start = start_pose(drive.world);
  if (!start) return Problem{{drive.world_file.string(), 0, "start"}, "is missing, and there is no tour"};
  drive.T_world_start = *start;
  if (!options.keys && drive.world.tour.size() < 2)
    return Problem{{drive.world_file.string(), 0, "tour"}, "needs at least two way points to be followed"};
  if (Problems problems = check_places(options, drive); !problems.empty()) return problems;
  return drive;
}

Result<std::optional<SessionRecord>> open_session(const DriveOptions& options, const Drive& drive) {
  if (options.out.empty()) return std::optional<SessionRecord>{};
  auto session = SessionRecord::create(options.out, options.force, drive.vehicle.description,
                                       {.navigator = "hand",
                                        .parameters = changed_parameters(drive.params.limits),
                                        .seed = options.seed,
                                        .simulated = true});
  if (!session) return session.problems();
  return std::optional<SessionRecord>(std::move(*session));
}

double rounded(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

Outcome outcome_of(const DriveOptions& options, const Drive& drive, const MissionEnd& end,
                   const SimulatedTruth& truth, std::size_t pictures, double worked_s) {
  Outcome outcome{.verb = "drive", .ok = end.arrived && truth.collisions == 0};
  const double factor = truth.stamp_s / std::max(worked_s, 1e-6);
  outcome.figures = {{"simulated", true},
                     {"seed", options.seed},
                     {"vehicle", drive.vehicle.description.name},
                     {"cycles", end.cycles},
                     {"duration_s", rounded(truth.stamp_s, 3)},
                     {"distance_m", rounded(truth.way_m, 3)},
                     {"pictures", pictures},
                     {"collisions", truth.collisions},
                     {"state", end.state},
                     {"why", end.why},
                     {"real_time_factor", rounded(factor, 1)}};
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format(
      "simulated drive through {} with {}: {:.1f} m in {:.1f} s, {} collision{}; {}{}{}\n"
      "{} pictures; {:.1f} times as fast as real time{}\n",
      drive.world.name, drive.vehicle.description.name, truth.way_m, truth.stamp_s, truth.collisions,
      truth.collisions == 1 ? "" : "s", end.state, end.why.empty() ? "" : ": ", end.why, pictures, factor,
      options.out.empty() ? "" : "; session in " + options.out.string());
  return outcome;
}

/// Ends a session; what was driven before an interruption stays.
Problems close(std::optional<SessionRecord>& session) {
  return session ? session->close() : Problems{};
}

Result<std::unique_ptr<Operator>> operator_of(const DriveOptions& options, const Drive& drive) {
  const VehicleDescription& vehicle = drive.vehicle.description;
  if (options.keys) return options.keys(vehicle, drive.params.keys);
  return std::unique_ptr<Operator>(std::make_unique<ScriptedOperator>(
      drive.world.tour, drive.world.places, vehicle, drive.params.person, options.seed));
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
  auto session = open_session(options, *drive);
  if (!session) return session.problems();

  SimulatedVehicle vehicle(
      drive->world, drive->vehicle, drive->scenario,
      {.seed = options.seed, .T_world_start = drive->T_world_start, .takes_pictures = options.takes_pictures},
      person->get());
  HandDriver driver(drive->params.limits);
  SimulatedRecord record(*session, vehicle);
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  const auto end = run_mission(vehicle, driver, record, console.progress);
  if (!end) return end.problems();
  if (const Problems problems = close(*session); !problems.empty()) return problems;

  Outcome outcome =
      outcome_of(options, *drive, *end, vehicle.truth(), record.pictures(), clock.now_s() - begun_s);
  if (const auto* scripted = dynamic_cast<const ScriptedOperator*>(person->get())) {
    outcome.figures["route_share"] = rounded(scripted->share_done(), 3);
    if (!scripted->has_arrived()) {
      outcome.ok = false;
      outcome.text += fmt::format("not arrived: {:.0f} % of the route\n", 100 * scripted->share_done());
    }
  }
  return outcome;
}

}  // namespace aisle
