#include <memory>

#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/refine.hpp"
#include "aisle/commands/teach.hpp"
#include "examples.hpp"
#include "live_options.hpp"
#include "operator_options.hpp"
#include "option_kinds.hpp"
#include "vehicle_options.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_teach_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "teach", "drive a route once by hand and record it for learning: simulated, or with a robot");
  verb->fallthrough();
  add_examples(
      *verb,
      {"aisle teach l-corridor --operator scripted --out out/shown",
       "aisle teach laboratory --method rooms --route \"parking frame\" --operator scripted --out out/shown",
       "aisle teach --connect robot.yaml --operator joystick --out out/shown"});
  auto options = std::make_shared<TeachOptions>();
  options->drive.vehicle.clear();
  auto operator_options = std::make_shared<OperatorOptions>();
  verb->add_option("WORLD", options->drive.world, "world file (YAML) or name of a shipped world");
  verb->add_option("--method", options->method, "learning method: landmarks (default), sections or rooms");
  verb->add_option("--route", options->route, "name of the route (default: route)");
  verb->add_option("--vehicle", options->drive.vehicle,
                   "vehicle file (YAML) or name of a shipped vehicle (default alv; mini for sections)");
  add_seed(*verb, options->drive.seed, "random seed; the same seed gives the same session (default 1)");
  verb->add_option("-o,--out", options->drive.out, "output directory for the session");
  verb->add_flag("--force", options->drive.force, "overwrite an existing session");
  add_storage(*verb, options->drive.storage);
  add_choice<bool>(
      *verb, "--views", options->shows_view_pattern, {{"trail", false}, {"pattern", true}},
      "views of a taught place (method rooms): from the path to it (default), or from a pattern of 63 "
      "poses around it, which a scripted person drives");
  add_operator_options(*verb, *operator_options);
  add_robot(*verb, options->drive.connection, {"WORLD", "--vehicle", "--seed"});
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->drive.parameters, drive_parameters, work, [=, &app, &work] {
    require_vehicle(options->drive.world, options->drive.connection);
    if (options->drive.out.empty()) throw CLI::RequiredError("--out");
    check_driver(*operator_options, live, options->drive);
    options->drive.keys = key_operator(*operator_options, app.count("--quiet") > 0);
    work = live.around([options, operator_options](Console& console, const DriveOptions::KeyOperator& hand) {
      TeachOptions taught = *options;
      if (operator_options->kind == OperatorKind::kPage) taught.drive.keys = hand;
      return run_teach(taught, console);
    });
  });
}

void add_learn_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("learn", "learn a building file from a taught run");
  verb->fallthrough();
  add_examples(*verb, {"aisle learn out/shown --out out/learned",
                       "aisle learn out/shown-1 out/shown-2 --method sections --out out/learned"});
  auto options = std::make_shared<LearnOptions>();
  verb->add_option("SESSION", options->sessions,
                   "session directory; with --method sections, several sessions of the same route");
  verb->add_option("--method", options->method, "learning method: landmarks (default), sections or rooms");
  verb->add_option("-o,--out", options->out, "output directory for building.json and its picture");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(*verb, options->parameters, learn_parameters, work, [=, &work] {
    if (options->sessions.empty()) throw CLI::RequiredError("SESSION");
    work = [options](Console& console) { return run_learn(*options, console); };
  });
}

void add_navigate_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("navigate", "drive a learned route autonomously: simulated, or with a robot");
  verb->fallthrough();
  add_examples(*verb,
               {"aisle navigate out/learned/building.json --world l-corridor",
                "aisle navigate out/learned/building.json --connect robot.yaml --speed 0.3 --out out/run"});
  auto options = std::make_shared<NavigateOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) from 'aisle learn'");
  verb->add_option("--world", options->world, "world file (YAML) or name of a shipped world");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML) or name of a shipped vehicle (default alv; mini for sections)");
  verb->add_option(
      "--faults", options->scenario,
      "scenario file (YAML) of faults to inject, or name of a shipped scenario (default: no faults)");
  verb->add_option("--method", options->method,
                   "method by which the route was learned: landmarks (default), sections or rooms");
  verb->add_option("--route", options->route, "name of the route (default: the first of the building)");
  verb->add_flag("--reverse", options->in_reverse, "drive the route in the opposite direction");
  verb->add_flag("--and-back", options->and_back,
                 "with --method sections: turn around at the end and drive back home");
  verb->add_option("--speed", options->speed_mps, "cruising speed [m/s]")->check(CLI::Range(0.05, 5.0));
  add_seed(*verb, options->seed, "random seed; the same seed gives the same session (default 1)");
  verb->add_option("-o,--out", options->out, "output directory for the session");
  verb->add_flag("--force", options->force, "overwrite an existing session");
  add_storage(*verb, options->storage);
  add_robot(*verb, options->connection, {"--world", "--vehicle", "--faults", "--seed"});
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, navigate_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    require_vehicle(options->world, options->connection);
    work = live.around([options](Console& console, const auto&) { return run_navigate(*options, console); });
  });
}

void add_refine_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "refine", "improve a learned building with more trips: its landmarks if it has any, else its walls");
  verb->fallthrough();
  add_examples(*verb, {"aisle refine out/learned/building.json out/run --out out/refined",
                       "aisle refine out/office/building.json friday.bag --out out/office-2",
                       "aisle refine out/office/building.json monday.bag tuesday.bag --json"});
  auto options = std::make_shared<RefineOptions>();
  verb->add_option(
      "BUILDING", options->building,
      "building file (JSON): from 'aisle learn', or with walls and floor; a map of map_server (YAML) or Bee");
  verb->add_option(
      "TRIP", options->trips,
      "for landmarks: sessions of runs along the building's routes; for walls: recordings of a 2-D "
      "laser scanner (CARMEN log, MRPT rawlog, CSV, ROS bag, session), taken in this order");
  verb->add_option_function<std::string>(
      "--at", [options](const std::string& text) { options->T_map_hint = parse_place("--at", text); },
      "where a laser recording begins, x,y,heading_deg in the map: a hint that is checked (default: "
      "anywhere)");
  add_reading_options(*verb, options->reading);
  verb->add_option("-o,--out", options->out,
                   "output directory for the refined building.json and its pictures");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(*verb, options->parameters, refine_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    if (options->trips.empty()) throw CLI::RequiredError("TRIP");
    work = [options](Console& console) { return run_refine(*options, console); };
  });
}

}  // namespace

void add_learning_verbs(CLI::App& app, Work& work) {
  add_teach_verb(app, work);
  add_learn_verb(app, work);
  add_navigate_verb(app, work);
  add_refine_verb(app, work);
}
