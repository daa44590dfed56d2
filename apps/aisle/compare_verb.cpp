#include <memory>

#include "aisle/commands/compare.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

void add_compare_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("compare", "say how far a trajectory is off true poses");
  verb->fallthrough();
  add_examples(*verb, {"aisle compare out/map/trajectory.tum truth.csv",
                       "aisle compare poses.tum drive.bag --truth /ground_truth --out out/compared"});
  auto options = std::make_shared<CompareOptions>();
  verb->add_option("TRAJECTORY", options->trajectory, "poses to judge: TUM (as `aisle map` writes) or CSV")
      ->required();
  verb->add_option("TRUTH", options->truth, "true poses: TUM, CSV, or a ROS bag")->required();
  verb->add_option("--truth", options->topic, "topic of a bag's true poses (default: the only one)");
  verb->add_option("--step", options->step_m,
                   "relative errors are over so much of the path, in metres (default 1)")
      ->check(CLI::Range(0.01, 1e4));
  verb->add_option("-o,--out", options->out, "output directory for the picture");
  verb->add_flag("--force", options->force, "overwrite existing results");
  verb->callback(
      [options, &work] { work = [options](Console& console) { return run_compare(*options, console); }; });
}
