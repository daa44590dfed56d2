#include "aisle/commands/show_world.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/geometry/box2.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/report/world_picture.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {
namespace {

/// The footprint of the shipped cart.
constexpr double kVehicleRadius_m = 0.3;
constexpr double kVehicleHeight_m = 1.3;

double to_centimetre(double value_m) {
  return std::round(value_m * 100) / 100;
}

double wall_length_m(const World& world) {
  double sum_m = 0;
  for (const WallFace& wall : world.walls) sum_m += wall.floor_edge.length();
  return sum_m;
}

Vec2 size_m(const World& world) {
  if (world.walls.empty()) return Vec2::Zero();
  return box_around(world.walls, &WallFace::floor_edge).sizes();
}

std::optional<Vec2> start_of(const World& world) {
  if (world.start) return world.start->position();
  if (!world.tour.empty()) return world.tour[0];
  return std::nullopt;
}

/// Where a vehicle can get to from the start, and what it cannot reach.
class Reach {
 public:
  explicit Reach(const World& world) : world_(world), obstacles_(obstacles_below(world, kVehicleHeight_m)) {}

  void add_to(Outcome& outcome, Console& console) const {
    add_tour(outcome, console);
    const std::optional<Vec2> start = start_of(world_);
    if (!start) return;
    const FreeFloor floor(obstacles_, *start, kVehicleRadius_m);
    add_floor(floor, outcome);
    add_unreached(floor, outcome, console);
  }

 private:
  void add_tour(Outcome& outcome, Console& console) const {
    if (world_.tour.empty()) return;
    const double tour_clearance_m = clearance_m(world_.tour, obstacles_);
    outcome.figures["tour_m"] = to_centimetre(polyline_length_m(world_.tour));
    outcome.text += fmt::format("  tour of {:.1f} m", polyline_length_m(world_.tour));
    if (std::isfinite(tour_clearance_m)) {
      outcome.figures["tour_clearance_m"] = to_centimetre(tour_clearance_m);
      outcome.text += fmt::format(", {:.2f} m from the nearest obstacle", tour_clearance_m);
    }
    outcome.text += "\n";
    if (tour_clearance_m < kVehicleRadius_m) {
      console.warn(fmt::format("the tour passes {:.2f} m from an obstacle; a vehicle {:g} m wide touches it",
                               tour_clearance_m, 2 * kVehicleRadius_m));
    }
  }

  void add_floor(const FreeFloor& floor, Outcome& outcome) const {
    const double area_m2 = floor.area_m2();
    if (!std::isfinite(area_m2)) {
      outcome.text += "  the floor leads out of the building\n";
      return;
    }
    outcome.figures["reached_m2"] = std::round(area_m2 * 10) / 10;
    outcome.text += fmt::format("  {:.1f} m2 of floor that a vehicle {:g} m wide can reach from the start\n",
                                area_m2, 2 * kVehicleRadius_m);
  }

  void add_unreached(const FreeFloor& floor, Outcome& outcome, Console& console) const {
    std::vector<std::string> unreached;
    const auto check = [&](const std::string& name, const Vec2& p) {
      if (!floor.reaches(p)) unreached.push_back(name);
    };
    for (const NamedPlace& place : world_.places) check(place.name, place.T_world_place.position());
    for (const ParkingFrame& frame : world_.parking_frames) check(frame.name, frame.centre);
    outcome.figures["unreached"] = unreached;
    for (const std::string& name : unreached) {
      console.warn(
          fmt::format("a vehicle {:g} m wide cannot get from the start to '{}'", 2 * kVehicleRadius_m, name));
    }
  }

  const World& world_;
  std::vector<Segment2> obstacles_;
};

Outcome describe(const World& world) {
  Outcome outcome{.verb = "sim show"};
  const Vec2 size = size_m(world);
  outcome.figures = {{"name", world.name},
                     {"width_m", to_centimetre(size.x())},
                     {"height_m", to_centimetre(size.y())},
                     {"area_m2", std::round(size.x() * size.y() * 10) / 10},
                     {"walls", world.walls.size()},
                     {"wall_m", to_centimetre(wall_length_m(world))},
                     {"doors", world.doors.size()},
                     {"posters", world.posters.size()},
                     {"lamps", world.lamps.size()},
                     {"papers", world.papers.size()},
                     {"furniture", world.furniture.size()},
                     {"parking_frames", world.parking_frames.size()},
                     {"boards", world.boards.size()},
                     {"people", world.people.size()},
                     {"places", world.places.size()}};
  outcome.text = fmt::format(
      "{}: {:.1f} m x {:.1f} m\n"
      "  {} wall faces of {:.1f} m together, {} doors, {} posters, {} lamps, {} papers\n"
      "  {} pieces of furniture, {} parking frames, {} people, {} places\n",
      world.name, size.x(), size.y(), world.walls.size(), wall_length_m(world), world.doors.size(),
      world.posters.size(), world.lamps.size(), world.papers.size(), world.furniture.size(),
      world.parking_frames.size(), world.people.size(), world.places.size());
  return outcome;
}

Problems check_outputs(const ShowWorldOptions& options) {
  Problems problems;
  for (const auto& path : {options.svg, options.png}) {
    std::error_code error;
    if (!path || !std::filesystem::exists(*path, error)) continue;
    if (std::filesystem::is_directory(*path, error)) {
      problems.push_back({{path->string()}, "is a directory"});
    } else if (!options.force) {
      problems.push_back({{path->string()}, "exists already; --force replaces it"});
    }
  }
  return problems;
}

Problems draw(const World& world, const ShowWorldOptions& options, Outcome& outcome) {
  const Vec2 size = size_m(world);
  const std::string caption = fmt::format("{:.1f} m x {:.1f} m, {} doors, {} places", size.x(), size.y(),
                                          world.doors.size(), world.places.size());
  const WorldPicture picture{world, world.name, caption};
  Problems problems;
  const auto write = [&](const char* role, const std::filesystem::path& path, const std::string& bytes) {
    const Problems more = write_whole_file(path, bytes);
    problems.insert(problems.end(), more.begin(), more.end());
    outcome.files[role] = path.string();
    outcome.text += fmt::format("  plan in {}\n", path.string());
  };
  if (options.svg) write("svg", *options.svg, svg(picture));
  if (options.png) write("png", *options.png, png(picture));
  return problems;
}

}  // namespace

Result<Outcome> run_show_world(const ShowWorldOptions& options, Console& console) {
  if (const Problems problems = check_outputs(options); !problems.empty()) return problems;
  const Result<World> world = read_shipped_or_own("worlds", options.world.string(), read_world);
  if (!world) return world.problems();
  Outcome outcome = describe(*world);
  Reach(*world).add_to(outcome, console);
  if (const Problems problems = draw(*world, options, outcome); !problems.empty()) return problems;
  return outcome;
}

}  // namespace aisle
