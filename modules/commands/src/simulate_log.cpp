#include "aisle/commands/simulate_log.hpp"

#include <fmt/format.h>

#include <cmath>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/simulation/operators/tour_recorder.hpp"
#include "aisle/simulation/operators/true_relations.hpp"

namespace aisle {
namespace {

double length_m(const std::vector<Pose2>& poses) {
  double sum_m = 0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    sum_m += (poses[i].position() - poses[i - 1].position()).norm();
  return sum_m;
}

/// FLASER lines contain no angles; the number of readings determines them.
Problems inexpressible(const RangeScannerParams& scanner) {
  constexpr double kSameAngle_rad = 1e-9;
  if (scanner.sensor.beams < 2) return {{{"", 0, "scanner.beams"}, "a log needs at least 2"}};
  const LaserScanner written = flaser_scanner(static_cast<std::size_t>(scanner.sensor.beams));
  const bool same = std::abs(written.first_angle_rad - scanner.laser.first_angle_rad) < kSameAngle_rad &&
                    std::abs(written.angle_step_rad - scanner.laser.angle_step_rad) < kSameAngle_rad;
  if (same) return {};
  return {{{"", 0, "scanner"},
           fmt::format(
               "a log with {} beams means first_angle_deg {:g} and angle_step_deg {:.6g}, not {:g} and {:g}",
               scanner.sensor.beams, to_degrees(written.first_angle_rad), to_degrees(written.angle_step_rad),
               to_degrees(scanner.laser.first_angle_rad), to_degrees(scanner.laser.angle_step_rad))}};
}

}  // namespace

Outcome simulate_log_parameters() {
  TourParams params;
  return parameter_listing("sim log", fields_of(params));
}

Result<Outcome> run_simulate_log(const SimulateLogOptions& options, Console& console) {
  TourParams params;
  FieldList fields = fields_of(params);
  if (const Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (const Problems problems = inexpressible(params.scanner); !problems.empty()) return problems;
  const auto world = read_shipped_or_own("worlds", options.world.string(), read_world);
  if (!world) return world.problems();
  if (world->tour.size() < 2)
    return Problem{{options.world.string(), 0, "tour"}, "needs at least two waypoints"};
  const auto out =
      OutputDirectory::open(options.out, options.force, {"simulated-trip.log", "true.relations", "true.tum"});
  if (!out) return out.problems();

  const TourRecording run = record_tour(*world, params, options.seed, console.progress);
  Random random(options.seed);
  const auto relations = true_relations(run.T_world_vehicle, random);
  std::vector<double> stamps_s;
  for (const LaserScan& scan : run.log.scans) stamps_s.push_back(scan.stamp_s);

  const auto written = out->write({{"log", "simulated-trip.log", carmen_text(run.log)},
                                   {"relations", "true.relations", relations_text(relations)},
                                   {"truth", "true.tum", tum_text(stamps_s, run.T_world_vehicle)}});
  if (!written) return written.problems();

  Outcome outcome{.verb = "sim log"};
  outcome.files = *written;
  const double path_m = length_m(run.T_world_vehicle);
  outcome.figures = {{"simulated", true},
                     {"seed", options.seed},
                     {"scans", run.log.scans.size()},
                     {"path_m", std::round(path_m * 100) / 100},
                     {"relations", relations.size()}};
  outcome.text = fmt::format("simulated run of {:.0f} m through {}: {} scans in {}\n", path_m, world->name,
                             run.log.scans.size(), outcome.files["log"]);
  return outcome;
}

}  // namespace aisle
