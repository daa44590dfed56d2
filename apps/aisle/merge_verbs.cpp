#include <memory>

#include "aisle/commands/diff.hpp"
#include "aisle/commands/merge.hpp"
#include "examples.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

constexpr const char* kMapFile = "building file (JSON) with a floor, or map of map_server (YAML) or Bee";

void add_diff_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand(
      "diff", "say what has changed between two maps of one building: walls, doors, floor");
  auto options = std::make_shared<DiffOptions>();
  verb->fallthrough();
  add_examples(*verb, {"aisle diff out/monday/building.json out/friday/building.json --out out/changes",
                       "aisle diff old.yaml new.yaml --json"});
  verb->add_option("OLD", options->old_building, kMapFile);
  verb->add_option("NEW", options->new_building, "a later map of the same building, in any frame");
  verb->add_option("-o,--out", options->out, "output directory for the pictures");
  verb->add_flag("--force", options->force, "overwrite existing pictures");
  add_parameter_options(*verb, options->parameters, diff_parameters, work, [options, &work] {
    if (options->old_building.empty()) throw CLI::RequiredError("OLD");
    if (options->new_building.empty()) throw CLI::RequiredError("NEW");
    work = [options](Console& console) { return run_diff(*options, console); };
  });
}

void add_merge_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("merge", "make one building of maps of its parts, wherever each of them began");
  auto options = std::make_shared<MergeOptions>();
  verb->fallthrough();
  add_examples(*verb, {"aisle merge out/east/building.json out/west/building.json --out out/whole",
                       "aisle merge a.yaml b.yaml c.yaml --json"});
  verb->add_option("BUILDING", options->buildings,
                   std::string(kMapFile) + "; at least two, the first one's frame is kept");
  verb->add_option("-o,--out", options->out, "output directory for building.json and its picture");
  verb->add_flag("--force", options->force, "overwrite existing results");
  add_parameter_options(*verb, options->parameters, merge_parameters, work, [options, &work] {
    if (options->buildings.size() < 2) throw CLI::RequiredError("two or more BUILDING");
    work = [options](Console& console) { return run_merge(*options, console); };
  });
}

}  // namespace

void add_merge_verbs(CLI::App& app, Work& work) {
  add_diff_verb(app, work);
  add_merge_verb(app, work);
}
