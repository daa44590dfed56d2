#include "aisle/simulation/buildings/random_building.hpp"

#include <fmt/format.h>

#include "aisle/core/parameters.hpp"
#include "aisle/simulation/buildings/decoration.hpp"
#include "buildings/building_furnishing.hpp"
#include "buildings/building_layout.hpp"

namespace aisle {
namespace {

constexpr double kInsideRoom_m = 1.15;  ///< from the doorway to the place in a room: past the open leaf

void check(Problems& problems, const char* key, const std::optional<double>& value, Range range) {
  if (!value || (*value >= range.min && *value <= range.max)) return;
  Problem problem;
  problem.where.key = key;
  problem.what = fmt::format("{:g} is outside {:g} .. {:g}", *value, range.min, range.max);
  problems.push_back(std::move(problem));
}

void choose_surfaces(World& world, Random& random) {
  static constexpr FloorCovering::Kind kFloors[] = {FloorCovering::Kind::kPlain, FloorCovering::Kind::kTiles,
                                                    FloorCovering::Kind::kCarpet};
  world.ceiling_m = random_centimetres(random, 2.4, 3.2);
  world.ceiling_brightness = random.uniform(0.7, 0.95);
  world.floor.kind = kFloors[random.index(3)];
  world.floor.tile_m = random_centimetres(random, 0.2, 0.6);
  world.floor.brightness = random.uniform(0.25, 0.65);
  world.floor.contrast = random.uniform(0.03, 0.2);
  world.skirting_height_m = with_probability(random, 0.75) ? random_centimetres(random, 0.06, 0.15) : 0;
  world.skirting_brightness = random.uniform(0.05, 0.4);
  world.ambient_light = random.uniform(0.2, 0.5);
  world.texture_seed = 1 + random.index(1'000'000);
}

void scatter_papers(World& world, const BuildingLayout& layout, Random& random) {
  const std::size_t papers = random.index(4);
  for (std::size_t i = 0; i < papers; ++i) {
    const Rectangle& floor = layout.corridors[random.index(layout.corridors.size())];
    const Vec2 inset = Vec2::Constant(0.3), size = floor.size() - 2 * inset;
    const Vec2 p = floor.min + inset + Vec2(random.uniform() * size.x(), random.uniform() * size.y());
    world.papers.push_back({.centre = p, .heading_rad = random.uniform(0, 2 * kPi)});
  }
}

void name_rooms(World& world, const BuildingLayout& layout) {
  int number = 0;
  for (const Room& room : layout.rooms) {
    ++number;
    if (!room.is_open) continue;
    const Vec2 inside = room.doorway.centre() + (layout.wall_thickness_m / 2 + kInsideRoom_m) * room.inwards;
    const double heading_rad = std::atan2(room.inwards.y(), room.inwards.x());
    world.places.push_back({fmt::format("room {}", number), {inside.x(), inside.y(), heading_rad}});
  }
}

}  // namespace

std::string_view name_of(BuildingKind kind) {
  switch (kind) {
    case BuildingKind::kOffice:
      return "office";
    case BuildingKind::kRing:
      return "ring";
    case BuildingKind::kComb:
      return "comb";
    case BuildingKind::kHall:
      return "hall";
  }
  return "";
}

Problems RandomBuildingRecipe::problems() const {
  Problems problems;
  check(problems, "size", size_m, {12, 200});
  check(problems, "corridor-width", corridor_width_m, {1.2, 5});
  return problems;
}

World random_building(const RandomBuildingRecipe& recipe, Random random) {
  BuildingLayout layout = random_corridors(recipe, random);
  add_rooms(layout, random);

  World world;
  choose_surfaces(world, random);
  const double brightness = random.uniform(0.5, 0.9);
  for (const Segment2& wall : walls_around(layout.floor())) {
    world.walls.push_back({.floor_edge = wall, .height_m = world.ceiling_m, .brightness = brightness});
  }
  hang_doors(world, layout, random);
  furnish(world, layout, random);
  hang_posters(world, random);
  hang_lamps(world, layout, random);
  scatter_papers(world, layout, random);
  world.tour = layout.tour;
  world.start = {layout.tour[0].x(), layout.tour[0].y(), Segment2{layout.tour[0], layout.tour[1]}.heading()};
  world.places = layout.places;
  name_rooms(world, layout);
  return world;
}

}  // namespace aisle
