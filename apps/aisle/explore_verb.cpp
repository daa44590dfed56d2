#include <memory>
#include <string>

#include "aisle/commands/explore.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

void add_explore_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("explore", "learn a building that nobody has shown, and come home");
  verb->fallthrough();
  auto options = std::make_shared<ExploreOptions>();
  verb->add_option("WORLD", options->world,
                   "world file (YAML), the name of a shipped one, or a plan as 'convert' reads them");
  add_resolution(*verb, options->plan_pixel_m);
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML), or the name of a shipped one (default: the one with the sensor)");
  add_exploring_sensor(*verb, options->sensor, "what shows it its surroundings (default scanner)");
  verb->add_option("--faults", options->scenario,
                   "scenario file (YAML) of what goes wrong, or the name of a shipped one");
  add_choice<ExploringOrder>(*verb, "--order", options->order,
                             {{"recommended", ExploringOrder::kRecommended},
                              {"published", ExploringOrder::kPublished},
                              {"nearest-frontier", ExploringOrder::kNearest}},
                             "in which order paths are taken (default recommended)");
  verb->add_option_function<std::string>(
          "--start",
          [options](const std::string& text) { options->T_world_start = parse_place("--start", text); },
          "where the vehicle is set down in the world: x,y,degrees (default: where the world says)")
      ->type_name("X,Y,DEG");
  verb->add_flag("--compare", options->compares, "drive by nearest frontier as well, and tell both ways");
  add_seed(*verb, options->seed, "of all noise; the same seed gives the same run (default 1)");
  verb->add_option("--out", options->out, "directory for building.json, the images and report.html");
  verb->add_option("--session", options->session, "directory to record the run in, as a session");
  verb->add_option("--resume", options->resumed,
                   "session of a run that was interrupted: it goes on from where it stood");
  verb->add_flag("--force", options->force, "replace results that are there already");
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, explore_parameters, work, [=, &work] {
    if (options->world.empty()) throw CLI::RequiredError("WORLD");
    work = live.around([options](Console& console, const auto&) { return run_explore(*options, console); });
  });
}
