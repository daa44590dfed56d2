#include <memory>

#include "aisle/live_session/live.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

void add_live_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "live",
      "run a vehicle that is watched, driven and sent on missions from a browser: simulated, or a robot");
  verb->fallthrough();
  add_examples(*verb, {"aisle live small-office --out out/live",
                       "aisle live --connect robot.yaml --listen 0.0.0.0 --token-file token --out out/live"});
  auto options = std::make_shared<LiveOptions>();
  auto out = std::make_shared<std::filesystem::path>();
  verb->add_option("WORLD", options->world, "world file (YAML) or name of a shipped world");
  verb->add_option(
      "--vehicle", options->vehicle,
      "vehicle file (YAML) or name of a shipped vehicle, for all missions (default: the usual one "
      "of each mission's verb; alv while it waits and is driven by hand)");
  add_seed(*verb, options->seed, "random seed (default 1)");
  verb->add_option(
      "-o,--out", *out,
      "output directory: sessions go to DIR/sessions and buildings to DIR/buildings, unless --sessions "
      "and --buildings name others");
  add_listening_options(*verb, options->listening);
  add_robot(*verb, options->connection, {"WORLD", "--vehicle", "--seed", "--rate"});
  verb->callback([=, &work] {
    require_vehicle(options->world, options->connection);
    LiveListening& listening = options->listening;
    if (!options->connection.empty()) listening.rate = 0;  // a robot keeps its own time
    if (listening.sessions.empty() && !out->empty()) listening.sessions = *out / "sessions";
    if (listening.buildings.empty() && !out->empty()) listening.buildings = *out / "buildings";
    work = [options](Console& console) { return run_live(*options, console, announce_live); };
  });
}
