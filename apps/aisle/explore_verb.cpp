#include <memory>
#include <string>

#include "aisle/commands/explore.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

void add_explore_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "explore", "explore an unknown building, come home and keep its map: simulated, or with a robot");
  verb->fallthrough();
  add_examples(*verb, {"aisle explore small-office --out out/office",
                       "aisle explore plan.png --resolution 0.05 --vehicle turtlebot --out out/plan",
                       "aisle explore --connect robot.yaml --session out/run --out out/explored --live"});
  auto options = std::make_shared<ExploreOptions>();
  verb->add_option("WORLD", options->world,
                   "world file (YAML), name of a shipped world, or a floor plan that 'aisle convert' reads");
  add_resolution(*verb, options->plan_pixel_m);
  verb->add_option(
      "--vehicle", options->vehicle,
      "vehicle file (YAML) or name of a shipped vehicle (default: the shipped one with the chosen sensor)");
  add_exploring_sensor(
      *verb, options->sensor,
      "sensor to explore with: range scanner, or line lasers with a camera (default scanner)");
  verb->add_option(
      "--faults", options->scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  add_choice<ExploringOrder>(*verb, "--order", options->order,
                             {{"recommended", ExploringOrder::kRecommended},
                              {"published", ExploringOrder::kPublished},
                              {"nearest-frontier", ExploringOrder::kNearest}},
                             "order in which open paths are taken (default recommended)");
  verb->add_option_function<std::string>(
          "--start",
          [options](const std::string& text) { options->T_world_start = parse_place("--start", text); },
          "initial pose in the world: x,y,degrees (default: the world's start)")
      ->type_name("X,Y,DEG");
  verb->add_flag("--compare", options->compares,
                 "also explore by nearest frontier, and report the distances of both");
  add_seed(*verb, options->seed, "random seed; the same seed gives the same run (default 1)");
  verb->add_option("-o,--out", options->out,
                   "output directory for building.json, the pictures and report.html");
  verb->add_option("--session", options->session, "directory to record the run in as a session");
  verb->add_option("--resume", options->resumed, "session of an interrupted run to continue");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_storage(*verb, options->storage);
  add_robot(*verb, options->connection,
            {"WORLD", "--resolution", "--vehicle", "--sensor", "--faults", "--start", "--compare", "--seed"});
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, explore_parameters, work, [=, &work] {
    require_vehicle(options->world, options->connection);
    work = live.around([options](Console& console, const auto&) { return run_explore(*options, console); });
  });
}
