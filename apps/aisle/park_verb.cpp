#include <memory>

#include "aisle/commands/park.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "parking_choices.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

void add_park_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("park", "park at the end of a route through a room: simulated, or with a robot");
  verb->fallthrough();
  add_examples(*verb, {"aisle park out/room/building.json \"parking frame\" --world laboratory",
                       "aisle park building.json charger --connect robot.yaml --out out/run"});
  auto options = std::make_shared<ParkOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) with the route");
  verb->add_option("PLACE", options->place, "name of the route to park at the end of");
  verb->add_option("--world", options->world, "world file (YAML) or name of a shipped world");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML) or name of a shipped vehicle (default alv)");
  verb->add_option(
      "--faults", options->scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  add_choice<std::optional<ParkingStrategy>>(*verb, "--strategy", options->strategy,
                                             parking_choices<std::optional<ParkingStrategy>>(),
                                             "parking strategy that the route must have been taught with");
  verb->add_option_function<std::string>(
          "--start",
          [options](const std::string& text) { options->T_world_start = parse_place("--start", text); },
          "initial pose in the world: x,y,degrees (default: on the route, 3 m before its end)")
      ->type_name("X,Y,DEG");
  verb->add_flag("--reverse", options->in_reverse,
                 "turn around in front of the painted frame and back into it");
  add_seed(*verb, options->seed, "random seed; the same seed gives the same session (default 1)");
  verb->add_option("-o,--out", options->out, "output directory for the session");
  verb->add_flag("--force", options->force, "overwrite an existing session");
  add_storage(*verb, options->storage);
  add_robot(*verb, options->connection, {"--world", "--vehicle", "--faults", "--start", "--seed"});
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, park_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    if (options->place.empty()) throw CLI::RequiredError("PLACE");
    require_vehicle(options->world, options->connection);
    work = live.around([options](Console& console, const auto&) { return run_park(*options, console); });
  });
}
