#include <memory>

#include "aisle/commands/simulate_log.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_log_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("log", "record a laser log on a simulated run along a world's tour");
  verb->fallthrough();
  auto options = std::make_shared<SimulateLogOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML) with a tour, or the name of a shipped one");
  add_seed(*verb, options->seed, "of all noise; the same seed gives the same log (default 1)");
  verb->add_option("--out", options->out, "directory for the log, the true poses and true relations");
  verb->add_flag("--force", options->force, "replace results that are there already");
  add_parameter_options(*verb, options->parameters, simulate_log_parameters, work, [options, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    if (options->out.empty()) throw CLI::RequiredError("--out");
    work = [options](Console& console) { return run_simulate_log(*options, console); };
  });
}
