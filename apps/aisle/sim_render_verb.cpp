#include <fmt/format.h>

#include <memory>

#include "aisle/commands/render_view.hpp"
#include "aisle/core/angle.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_render_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("render", "render the image of a vehicle's camera at a given pose");
  verb->fallthrough();
  add_examples(*verb, {"aisle sim render busy-corridor --vehicle alv --camera corridor --laser -o view.png",
                       "aisle sim render small-office --pose 2,1,90 --light 0.5 -o view.jpg"});
  auto options = std::make_shared<RenderViewOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML) or name of a shipped world");
  verb->add_option(
          "--vehicle", options->vehicle,
          "vehicle file (YAML) or name of a shipped vehicle (default: a standard camera 1 m above the floor)")
      ->type_name("FILE");
  verb->add_option("--camera", options->camera, "name of the vehicle's camera (default: its first)");
  verb->add_option_function<std::string>(
          "--pose",
          [options](const std::string& text) { options->T_world_vehicle = parse_place("--pose", text); },
          "pose of the vehicle in the world: x,y,degrees (default: the world's start)")
      ->type_name("X,Y,DEG");
  verb->add_option("--light", options->light, "factor on all light (default 1)")
      ->check(CLI::Range(0.0, 100.0));
  verb->add_flag("--lamps-off", options->lamps_off, "switch the lamps off: ambient light only");
  verb->add_flag("--laser", options->laser, "switch the line lasers on");
  add_seed(*verb, options->seed, "random seed of the noise (default 1)");
  verb->add_option("-o,--out", options->out, "image file to write, .png or .jpg")->type_name("FILE");
  verb->add_flag("--force", options->force, "overwrite an existing image");
  add_parameter_options(*verb, options->parameters, render_view_parameters, work, [options, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    if (options->out.empty()) throw CLI::RequiredError("--out");
    work = [options](Console& console) { return run_render_view(*options, console); };
  });
}
