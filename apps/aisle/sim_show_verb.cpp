#include <memory>

#include "aisle/commands/show_world.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_show_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("show", "draw a world's plan and say what is in it");
  verb->fallthrough();
  auto options = std::make_shared<ShowWorldOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML), or the name of a shipped one")->required();
  verb->add_option("--svg", options->svg, "draw the plan as SVG")->type_name("FILE");
  verb->add_option("--png", options->png, "draw the plan as PNG")->type_name("FILE");
  verb->add_flag("--force", options->force, "replace images that are there already");
  verb->callback(
      [options, &work] { work = [options](Console& console) { return run_show_world(*options, console); }; });
}
