#include "aisle/commands/convert.hpp"

#include <memory>

#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_random_options(CLI::App& verb, ConvertOptions& options) {
  verb.add_option("--random", options.seed,
                  "make a building by chance instead; the same seed gives the same one")
      ->type_name("SEED");
  Choices<BuildingKind> kinds;
  for (const BuildingKind kind : kBuildingKinds) kinds.emplace_back(name_of(kind), kind);
  add_choice<BuildingKind>(verb, "--kind", options.recipe.kind, kinds,
                           "of a random building (default office)");
  verb.add_option("--size", options.recipe.size_m,
                  "length of a random building's longest corridor in metres (default by chance, 20 to 60)")
      ->check(CLI::Range(12.0, 200.0));
}

void add_corridor_width(CLI::App& verb, ConvertOptions& options) {
  const auto set = [&options](double width_m) {
    options.maze.corridor_width_m = width_m;
    options.recipe.corridor_width_m = width_m;
  };
  verb.add_option_function<double>(
          "--corridor-width", set,
          "in metres (default: 1.8 in a maze, 1.2 to 3 by chance in a random building)")
      ->check(CLI::Range(0.8, 10.0));
}

}  // namespace

void add_convert_verb(CLI::App& app, Work& work) {
  CLI::App* verb =
      app.add_subcommand("convert", "make a world to drive in from a floor plan, a maze, or by chance");
  verb->fallthrough();
  auto options = std::make_shared<ConvertOptions>();
  verb->add_option(
      "PLAN", options->plan,
      "wall-segment text, an image (PBM, PGM, PNG), a map_server YAML file, a maze; plain or gzip");
  add_choice<PlanKind>(*verb, "--from", options->from,
                       {{"segments", PlanKind::kSegments},
                        {"picture", PlanKind::kImage},
                        {"map_server", PlanKind::kMapServer},
                        {"maze", PlanKind::kMaze}},
                       "what PLAN is (default: known from its content)");
  add_resolution(*verb, options->resolution_m);
  verb->add_option("--tolerance", options->tracing.tolerance_cells,
                   "how far a straight wall may lie from the pixels' border, in pixels (default 1)")
      ->check(CLI::Range(0.5, 5.0));
  verb->add_option("--speck", options->speck_m,
                   "what fits into a square of this side is left out of an image, in metres (default 0.1)")
      ->check(CLI::Range(0.0, 2.0));
  add_corridor_width(*verb, *options);
  verb->add_option("--wall-thickness", options->maze.wall_thickness_m, "of a maze, in metres (default 0.15)")
      ->check(CLI::Range(0.05, 5.0));
  verb->add_option("--vehicle-width", options->run.vehicle_width_m,
                   "of the vehicle that start and tour are for, in metres (default 0.6)")
      ->check(CLI::Range(0.05, 5.0));
  add_random_options(*verb, *options);
  verb->add_flag("--dress", options->dress,
                 "give a plan closed doors, posters and lamps; random buildings have them");
  verb->add_option("-o,--out", options->out, "the world file to write");
  verb->add_flag("--force", options->force, "replace the file if it is there already");
  verb->callback([=, &work] {
    if (options->plan.empty() && !options->seed) throw CLI::RequiredError("PLAN");
    if (!options->plan.empty() && options->seed) {
      throw CLI::ValidationError("PLAN", "there is no plan to read with --random");
    }
    if (options->out.empty()) throw CLI::RequiredError("--out");
    work = [options](Console& console) { return run_convert(*options, console); };
  });
}
