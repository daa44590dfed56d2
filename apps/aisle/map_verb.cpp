#include <memory>

#include "aisle/commands/map.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_map_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("map", "build a wall map from a recorded 2-D laser log with odometry");
  auto options = std::make_shared<MapOptions>();
  verb->fallthrough();
  add_examples(*verb, {"aisle map drive.bag --out out/map",
                       "aisle map scans.csv --units mm --laser-offset 0.1,0,0 --out out/map",
                       "aisle map drive.clf.gz --relations drive.relations --stages"});
  verb->add_option("LOG", options->log,
                   "recording of a 2-D laser scanner: CARMEN log, MRPT rawlog, CSV, ROS bag");
  add_reading_options(*verb, options->reading);
  verb->add_option("--relations", options->relations,
                   "file of known relative poses, to measure the error against");
  add_choice<MapRules>(*verb, "--rules", options->rules,
                       {{"published", MapRules::kPublished}, {"refined", MapRules::kRefined}},
                       "mapping rules; published: Algorithms 2 and 3 of C99 only (default refined)");
  verb->add_option("-o,--out", options->out, "output directory for the map, its pictures and the trajectory");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_choice<MapMode>(*verb, "--map-mode", options->map_mode,
                      {{"trinary", MapMode::kTrinary}, {"scale", MapMode::kScale}, {"raw", MapMode::kRaw}},
                      "mode of the map of cells for map_server (default trinary)");
  verb->add_flag(
      "--floor,!--no-floor", options->keeps_floor,
      "keep the floor that was seen in building.json, too (default): `localise`, `diff` and `merge` need it");
  verb->add_option("--odometry-delay", options->odometry_delay_s,
                   "delay of the odometry behind its scan in seconds (default: estimated from the log)")
      ->check(CLI::Range(-10.0, 10.0));
  verb->add_flag("--stages", options->stages, "print the figures of every processing stage");
  add_parameter_options(*verb, options->parameters, map_parameters, work, [options, &work] {
    if (options->log.empty()) throw CLI::RequiredError("LOG");
    work = [options](Console& console) { return run_map(*options, console); };
  });
}
