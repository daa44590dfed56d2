#include <memory>

#include "aisle/commands/reproduce.hpp"
#include "verb.hpp"

using namespace aisle;

void add_reproduce_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("reproduce", "a published experiment in simulation, beside its figures");
  verb->fallthrough();
  auto options = std::make_shared<ReproduceOptions>();
  verb->add_option(
      "EXPERIMENT", options->experiment,
      "c98: a corridor learned, driven and refined five times; c99: unknown corridors explored by\n"
      "laser markers and one camera; l03: a corridor learned from one drive by sections, driven there\n"
      "and back");
  verb->add_option("--seed", options->seed, "of everything that is left to chance (default 1)");
  verb->add_option("--out", options->out, "directory for the images and the learned building");
  verb->add_flag("--force", options->force, "replace results that are already there");
  add_parameter_options(*verb, options->parameters, reproduce_parameters, work, [=, &work] {
    if (options->experiment.empty()) throw CLI::RequiredError("EXPERIMENT");
    work = [options](Console& console) { return run_reproduce(*options, console); };
  });
}
