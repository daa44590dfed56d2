#include <memory>

#include "aisle/commands/guide.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_mission_options(CLI::App& verb, GuideOptions& options) {
  verb.add_option("--world", options.world,
                  "world file (YAML), name of a shipped world, or a floor plan that 'aisle convert' reads");
  add_resolution(verb, options.plan_pixel_m);
  verb.add_option_function<std::string>(
      "--start",
      [&options](const std::string& text) { options.T_world_start = parse_place("--start", text); },
      "put the simulated vehicle down at x,y,heading_deg of the world, and do not tell it (default: at "
      "home)");
  verb.add_option_function<std::string>(
      "--at", [&options](const std::string& text) { options.told = parse_told_start(text); },
      "where it begins: home, unknown (it finds itself), or x,y,heading_deg in the map, a hint that is "
      "checked "
      "(default: home; unknown with --start)");
  verb.add_option("--vehicle", options.vehicle,
                  "vehicle file (YAML) or name of a shipped vehicle (default alv-scanner)");
  verb.add_option(
      "--faults", options.scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  add_seed(verb, options.seed, "random seed; the same seed gives the same session (default 1)");
  verb.add_option("-o,--out", options.out, "output directory for the session");
  verb.add_flag("--force", options.force, "overwrite an existing session");
  add_storage(verb, options.storage);
  add_robot(verb, options.connection,
            {"--world", "--resolution", "--vehicle", "--faults", "--seed", "--start"});
}

void require(const GuideOptions& options) {
  if (options.building.empty()) throw CLI::RequiredError("BUILDING");
  require_vehicle(options.world, options.connection);
}

void add_go_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "go", "drive from home to places in an explored building: simulated, or with a robot");
  verb->fallthrough();
  add_examples(*verb,
               {"aisle go out/office/building.json \"end 1\" 3.5,2,90 --world small-office",
                "aisle go out/office/building.json 3.5,2 --world small-office --start 4,1,90 --at unknown",
                "aisle go building.json kitchen --connect robot.yaml --live"});
  auto options = std::make_shared<GuideOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) from 'aisle explore'");
  verb->add_option("PLACE", options->places,
                   "goal: name of a place or of a corridor node (\"end 1\"), x,y in the map frame [m], or "
                   "x,y,heading_deg; there it turns to the heading, if one is given or the place has one; "
                   "several are driven to in order; "
                   "with --connect and without it: the goals of the robot's viewer, on /goal_pose");
  add_mission_options(*verb, *options);
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, guide_parameters, work, [=, &work] {
    require(*options);
    if (options->places.empty() && options->connection.empty()) throw CLI::RequiredError("PLACE");
    work = live.around([options](Console& console, const auto&) { return run_go(*options, console); });
  });
}

void add_patrol_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "patrol",
      "drive along all corridors of an explored building, about once per round: simulated, or with a robot");
  verb->fallthrough();
  add_examples(*verb, {"aisle patrol out/office/building.json --world small-office --rounds 2",
                       "aisle patrol building.json --connect robot.yaml --out out/run"});
  auto options = std::make_shared<GuideOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) from 'aisle explore'");
  verb->add_option("--rounds", options->rounds, "number of rounds (default 1)")->check(CLI::Range(1, 1000));
  add_mission_options(*verb, *options);
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, guide_parameters, work, [=, &work] {
    require(*options);
    work = live.around([options](Console& console, const auto&) { return run_patrol(*options, console); });
  });
}

}  // namespace

void add_guide_verbs(CLI::App& app, Work& work) {
  add_go_verb(app, work);
  add_patrol_verb(app, work);
}
