#include <memory>

#include "aisle/commands/show_world.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_show_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("show", "draw the plan of a world and list its contents");
  verb->fallthrough();
  add_examples(*verb,
               {"aisle sim show small-office", "aisle sim show plan.yaml --svg plan.svg --png plan.png"});
  auto options = std::make_shared<ShowWorldOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML) or name of a shipped world")->required();
  verb->add_option("--svg", options->svg, "file for the plan as SVG")->type_name("FILE");
  verb->add_option("--png", options->png, "file for the plan as PNG")->type_name("FILE");
  verb->add_flag("--force", options->force, "overwrite existing images");
  verb->callback(
      [options, &work] { work = [options](Console& console) { return run_show_world(*options, console); }; });
}
