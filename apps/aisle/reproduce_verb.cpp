#include <memory>

#include "aisle/trials/reproduce.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

void add_reproduce_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("reproduce", "repeat a published experiment in simulation and compare the figures");
  verb->fallthrough();
  add_examples(*verb, {"aisle reproduce c98", "aisle reproduce c99 --seed 2 --out out/c99"});
  auto options = std::make_shared<ReproduceOptions>();
  verb->add_option(
      "EXPERIMENT", options->experiment,
      "c98: learn a corridor, then drive and refine it five times; c99: explore unknown corridors with\n"
      "line lasers and one camera; l03: learn a corridor as sections from one drive, then drive there\n"
      "and back");
  verb->add_option("--seed", options->seed, "random seed (default 1)");
  verb->add_option("-o,--out", options->out, "output directory for the pictures and the learned building");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(*verb, options->parameters, reproduce_parameters, work, [=, &work] {
    if (options->experiment.empty()) throw CLI::RequiredError("EXPERIMENT");
    work = [options](Console& console) { return run_reproduce(*options, console); };
  });
}
