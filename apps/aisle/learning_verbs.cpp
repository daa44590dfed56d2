#include <memory>

#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/refine.hpp"
#include "aisle/commands/teach.hpp"
#include "hands.hpp"
#include "live_options.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_teach_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("teach", "drive a route once by hand, for a method to learn it");
  verb->fallthrough();
  auto options = std::make_shared<TeachOptions>();
  options->drive.vehicle.clear();
  auto hands = std::make_shared<HandOptions>();
  verb->add_option("WORLD", options->drive.world, "world file (YAML), or the name of a shipped one");
  verb->add_option("--method", options->method,
                   "how it will be learned: landmarks (default), sections or route");
  verb->add_option("--route", options->route, "name of the route (default route)");
  verb->add_option("--vehicle", options->drive.vehicle,
                   "vehicle file (YAML), or the name of a shipped one (default alv; mini for sections)");
  add_seed(*verb, options->drive.seed, "of all noise; the same seed gives the same session (default 1)");
  verb->add_option("--out", options->drive.out, "directory for the session");
  verb->add_flag("--force", options->drive.force, "replace a session that is there already");
  add_choice<bool>(
      *verb, "--views", options->shows_view_pattern, {{"trail", false}, {"pattern", true}},
      "of a taught place (route): from the path to it (default), or from the 63 places about it, "
      "which a scripted person drives");
  add_hand_options(*verb, *hands);
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->drive.parameters, drive_parameters, work, [=, &app, &work] {
    if (options->drive.world.empty()) throw CLI::RequiredError("WORLD");
    if (options->drive.out.empty()) throw CLI::RequiredError("--out");
    check_page_driver(*hands, live);
    options->drive.keys = key_operator(*hands, app.count("--quiet") > 0);
    work = live.around([options, hands](Console& console, const DriveOptions::KeyOperator& hand) {
      TeachOptions taught = *options;
      if (hands->person == Hands::kPage) taught.drive.keys = hand;
      return run_teach(taught, console);
    });
  });
}

void add_learn_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("learn", "make a building of a run that was taught");
  verb->fallthrough();
  auto options = std::make_shared<LearnOptions>();
  verb->add_option("SESSION", options->sessions, "the session's directory; sections: several of one way");
  verb->add_option("--method", options->method, "how it is learned: landmarks (default), sections or route");
  verb->add_option("--out", options->out, "directory for building.json and its image");
  verb->add_flag("--force", options->force, "replace results that are there already");
  add_parameter_options(*verb, options->parameters, learn_parameters, work, [=, &work] {
    if (options->sessions.empty()) throw CLI::RequiredError("SESSION");
    work = [options](Console& console) { return run_learn(*options, console); };
  });
}

void add_navigate_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("navigate", "drive a learned route alone, in the simulator");
  verb->fallthrough();
  auto options = std::make_shared<NavigateOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) that was learned");
  verb->add_option("--world", options->world, "world file (YAML), or the name of a shipped one");
  verb->add_option("--vehicle", options->vehicle,
                   "vehicle file (YAML), or the name of a shipped one (default alv; mini for sections)");
  verb->add_option("--faults", options->scenario,
                   "scenario file (YAML) of what goes wrong, or the name of a shipped one");
  verb->add_option("--method", options->method, "how it was learned: landmarks (default), sections or route");
  verb->add_option("--route", options->route, "name of the route (default: the first)");
  verb->add_flag("--reverse", options->in_reverse, "drive the route's return path");
  verb->add_flag("--and-back", options->and_back, "sections: there, turned about, and home again");
  verb->add_option("--speed", options->speed_mps, "speed where nothing speaks against it [m/s]")
      ->check(CLI::Range(0.05, 5.0));
  add_seed(*verb, options->seed, "of all noise; the same seed gives the same session (default 1)");
  verb->add_option("--out", options->out, "directory for the session");
  verb->add_flag("--force", options->force, "replace a session that is there already");
  const LiveOption live(*verb);
  add_parameter_options(*verb, options->parameters, navigate_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    if (options->world.empty()) throw CLI::RequiredError("--world");
    work = live.around([options](Console& console, const auto&) { return run_navigate(*options, console); });
  });
}

void add_refine_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("refine", "make a learned building better by more runs");
  verb->fallthrough();
  auto options = std::make_shared<RefineOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON) that was learned");
  verb->add_option("SESSION", options->sessions, "sessions of runs along its routes");
  verb->add_option("--out", options->out, "directory for the refined building.json and its image");
  verb->add_flag("--force", options->force, "replace results that are there already");
  add_parameter_options(*verb, options->parameters, refine_parameters, work, [=, &work] {
    if (options->building.empty()) throw CLI::RequiredError("BUILDING");
    if (options->sessions.empty()) throw CLI::RequiredError("SESSION");
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
