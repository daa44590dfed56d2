#include <memory>

#include "aisle/commands/list_shipped.hpp"
#include "aisle/commands/show_building.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_list_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("list", "list the worlds, vehicles and scenarios that come with aisle");
  verb->fallthrough();
  add_examples(*verb, {"aisle list", "aisle list worlds"});
  auto kind = std::make_shared<std::string>();
  verb->add_option("KIND", *kind, "worlds, vehicles or scenarios (default: all)")
      ->check(CLI::IsMember({"worlds", "vehicles", "scenarios"}));
  verb->callback([kind, &work] { work = [kind](Console&) { return run_list_shipped(*kind); }; });
}

void add_show_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("show", "say what is known of a building, and draw it");
  verb->fallthrough();
  add_examples(*verb, {"aisle show out/office/building.json", "aisle show map.yaml --out out/map"});
  auto options = std::make_shared<ShowBuildingOptions>();
  verb->add_option("BUILDING", options->building, "building file (JSON), or map of map_server (YAML) or Bee")
      ->required();
  verb->add_option("-o,--out", options->out, "output directory for the picture");
  verb->add_flag("--force", options->force, "overwrite an existing picture");
  verb->callback([options, &work] {
    work = [options](Console& console) { return run_show_building(*options, console); };
  });
}

}  // namespace

void add_show_verbs(CLI::App& app, Work& work) {
  add_list_verb(app, work);
  add_show_verb(app, work);
}
