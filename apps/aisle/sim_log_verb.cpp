#include <memory>

#include "aisle/commands/simulate_log.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_log_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("log", "record the laser log of a simulated run along a world's tour");
  verb->fallthrough();
  add_examples(*verb, {"aisle sim log small-office --out out/log",
                       "aisle sim log small-office --seed 2 --out out/log-2"});
  auto options = std::make_shared<SimulateLogOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML) with a tour, or name of a shipped world");
  add_seed(*verb, options->seed, "random seed; the same seed gives the same log (default 1)");
  verb->add_option("-o,--out", options->out,
                   "output directory for the log, the true poses and the true relative poses");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(*verb, options->parameters, simulate_log_parameters, work, [options, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    if (options->out.empty()) throw CLI::RequiredError("--out");
    work = [options](Console& console) { return run_simulate_log(*options, console); };
  });
}
