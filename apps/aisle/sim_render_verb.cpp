#include <fmt/format.h>

#include <memory>

#include "aisle/commands/render_view.hpp"
#include "aisle/core/angle.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_sim_render_verb(CLI::App& sim, Work& work) {
  CLI::App* verb = sim.add_subcommand("render", "take the image that a vehicle's camera sees at a place");
  verb->fallthrough();
  auto options = std::make_shared<RenderViewOptions>();
  verb->add_option("WORLD", options->world, "world file (YAML), or the name of a shipped one");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML); else an ordinary camera 1 m above the floor")
      ->type_name("FILE");
  verb->add_option("--camera", options->camera, "of the vehicle, by its name; else its first");
  verb->add_option_function<std::string>(
          "--at",
          [options](const std::string& text) { options->T_world_vehicle = parse_place("--at", text); },
          "where the vehicle is: x,y,degrees; else at the world's start")
      ->type_name("X,Y,DEG");
  verb->add_option("--light", options->light, "all light times this (default 1)")
      ->check(CLI::Range(0.0, 100.0));
  verb->add_flag("--lamps-off", options->lamps_off, "only the light that comes from everywhere");
  verb->add_flag("--laser", options->laser, "the laser markers are on");
  add_seed(*verb, options->seed, "of noise (default 1)");
  verb->add_option("-o,--output", options->out, "the image, .png or .jpg")->type_name("FILE");
  verb->add_flag("--force", options->force, "replace an image that is there already");
  add_parameter_options(*verb, options->parameters, render_view_parameters, work, [options, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    if (options->out.empty()) throw CLI::RequiredError("-o");
    work = [options](Console& console) { return run_render_view(*options, console); };
  });
}
