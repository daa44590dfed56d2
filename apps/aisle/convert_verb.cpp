#include "aisle/commands/convert.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "aisle/commands/convert_map.hpp"
#include "examples.hpp"
#include "option_kinds.hpp"
#include "verb.hpp"

using namespace aisle;

namespace {

void add_random_options(CLI::App& verb, ConvertOptions& options) {
  verb.add_option("--random", options.seed,
                  "generate a random building instead; the same seed gives the same building")
      ->type_name("SEED");
  Choices<BuildingKind> kinds;
  for (const BuildingKind kind : kBuildingKinds) kinds.emplace_back(name_of(kind), kind);
  add_choice<BuildingKind>(verb, "--kind", options.recipe.kind, kinds,
                           "kind of random building (default office)");
  verb.add_option("--corridor-length", options.recipe.size_m,
                  "length of the longest corridor of a random building in metres (default: random, 20 to 60)")
      ->check(CLI::Range(12.0, 200.0));
}

void add_corridor_width(CLI::App& verb, ConvertOptions& options) {
  const auto set = [&options](double width_m) {
    options.maze.corridor_width_m = width_m;
    options.recipe.corridor_width_m = width_m;
  };
  verb.add_option_function<double>(
          "--corridor-width", set,
          "corridor width in metres (default: 1.8 in a maze; random, 1.2 to 3, in a random building)")
      ->check(CLI::Range(0.8, 10.0));
}

/// Share of black, or a grey value above 1: what is darker is solid.
double solid_from_black(double threshold) {
  return threshold <= 1 ? threshold : (256 - threshold) / 255;
}

/// "x,y x,y LENGTH" with or without m behind: two points of the plan and the metres between them.
double parse_scale(const std::string& text) {
  constexpr double kLongest_m = 1e5;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, length_m = 0;
  char comma0 = 0, comma1 = 0;
  std::istringstream in(text);
  std::string unit;
  const bool is_complete = static_cast<bool>(in >> x0 >> comma0 >> y0 >> x1 >> comma1 >> y1 >> length_m);
  in >> unit;
  const double distance = std::hypot(x1 - x0, y1 - y0);
  if (is_complete && comma0 == ',' && comma1 == ',' && (unit.empty() || unit == "m") &&
      (in >> std::ws).eof() && distance > 0 && length_m > 0 && length_m <= kLongest_m)
    return length_m / distance;
  throw CLI::ValidationError(
      "--scale-by", "'" + text + "' is not two different points and a length in metres: \"x,y x,y 12.5 m\"");
}

void add_drawing_options(CLI::App& verb, ConvertOptions& options) {
  verb.add_option_function<double>(
          "--threshold",
          [&options](double threshold) { options.solid_from_black = solid_from_black(threshold); },
          "share of black (0 to 1) from which a pixel is a wall, or the grey value (2 to 255) below which it "
          "is "
          "(default 0.196)")
      ->check(CLI::Range(0.001, 255.0));
  verb.add_option_function<std::string>(
      "--scale-by", [&options](const std::string& text) { options.scale_m = parse_scale(text); },
      "scale by two points of an image (pixels) or drawing (its units) and their distance in metres: \"x,y "
      "x,y 12.5 "
      "m\"");
}

/// "NAME=x,y" or "NAME=x,y,heading_deg"
MapPlace parse_named_place(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0)
    throw CLI::ValidationError("--place", "'" + text + "' is not NAME=x,y or NAME=x,y,heading_deg (metres)");
  std::string pose = text.substr(equals + 1);
  const bool has_heading = std::count(pose.begin(), pose.end(), ',') != 1;
  if (!has_heading) pose += ",0";
  return {text.substr(0, equals), parse_place("--place", pose), has_heading};
}

/// @return the flag that asks for a building
CLI::Option* add_building_options(CLI::App& verb, ConvertMapOptions& options) {
  CLI::Option* const flag = verb.add_flag("--building");
  flag->description(
      "make a building to drive in of a map that others made (map_server, slam_toolbox, Cartographer), in "
      "place of a world to simulate");
  verb.add_option_function<std::vector<std::string>>(
          "--place",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) options.places.push_back(parse_named_place(text));
          },
          "a place of the building, NAME=x,y or NAME=x,y,heading_deg in the map [m]; repeatable (default: "
          "home at the map's origin)")
      ->allow_extra_args(false)
      ->type_name("NAME=x,y")
      ->needs(flag);
  verb.add_option("--keep-out", options.keep_out,
                  "keep-out mask of Nav2 (map_server YAML file): its occupied cells become barriers")
      ->needs(flag);
  return flag;
}

}  // namespace

void add_convert_verb(CLI::App& app, Work& work) {
  CLI::App* verb = app.add_subcommand("convert", "make a world from a floor plan, from a maze, or at random");
  verb->fallthrough();
  add_examples(*verb, {"aisle convert plan.png --resolution 0.05 --speck 0.3 -o plan.yaml",
                       "aisle convert --random 7 --kind office -o building.yaml",
                       "aisle convert map.yaml --building --place home=0,0,0 --keep-out mask.yaml -o "
                       "building.json"});
  auto options = std::make_shared<ConvertOptions>();
  verb->add_option(
      "PLAN", options->plan,
      "wall-segment text, image (PBM, PGM, PNG), drawing (SVG, PDF, DXF), map_server YAML file, Bee map or "
      "maze; plain or gzip");
  add_choice<PlanKind>(*verb, "--plan-format", options->from,
                       {{"segments", PlanKind::kSegments},
                        {"picture", PlanKind::kImage},
                        {"drawing", PlanKind::kDrawing},
                        {"map_server", PlanKind::kMapServer},
                        {"bee", PlanKind::kBeeMap},
                        {"maze", PlanKind::kMaze}},
                       "format of PLAN (default: detected from its content)");
  add_resolution(*verb, options->resolution_m);
  add_drawing_options(*verb, *options);
  verb->add_option(
          "--tolerance", options->tracing.tolerance_cells,
          "greatest distance of a straight wall from the border it is traced from, in pixels (default 1)")
      ->check(CLI::Range(0.5, 5.0));
  verb->add_option(
          "--speck", options->speck_m,
          "remove specks of an image that fit into a square of this side, in metres (default 0: none)")
      ->check(CLI::Range(0.0, 2.0));
  add_corridor_width(*verb, *options);
  verb->add_option("--wall-thickness", options->maze.wall_thickness_m,
                   "wall thickness in a maze in metres (default 0.15)")
      ->check(CLI::Range(0.05, 5.0));
  verb->add_option("--vehicle-width", options->run.vehicle_width_m,
                   "width of the vehicle that start and tour are planned for, in metres (default 0.6)")
      ->check(CLI::Range(0.05, 5.0));
  add_random_options(*verb, *options);
  verb->add_flag("--dress", options->dress,
                 "decorate a plan with closed doors, posters and lamps; random buildings always have them");
  auto map_options = std::make_shared<ConvertMapOptions>();
  const CLI::Option* const is_building = add_building_options(*verb, *map_options);
  verb->add_option("-o,--out", options->out, "world or building file to write");
  verb->add_flag("--force", options->force, "overwrite an existing file");
  verb->callback([=, &work] {
    if (options->plan.empty() && !options->seed) throw CLI::RequiredError("PLAN");
    if (!options->plan.empty() && options->seed) {
      throw CLI::ValidationError("PLAN", "cannot be combined with --random");
    }
    if (options->out.empty()) throw CLI::RequiredError("--out");
    if (is_building->count() > 0) {
      if (options->plan.empty()) throw CLI::RequiredError("PLAN");
      map_options->map = options->plan;
      map_options->out = options->out;
      map_options->force = options->force;
      work = [map_options](Console& console) { return run_convert_map(*map_options, console); };
      return;
    }
    work = [options](Console& console) { return run_convert(*options, console); };
  });
}
