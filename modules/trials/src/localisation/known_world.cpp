#include "localisation/known_world.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "aisle/commands/known_building.hpp"
#include "aisle/geometry/box2.hpp"
#include "aisle/simulation/cross_section.hpp"

namespace aisle {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kMargin_m = 0.5;
constexpr double kMissingShare = 0.05;  // of the walls' length
constexpr double kMissing_m = 1;        // in pieces of this length
constexpr double kMoved_m = 0.5;        // standard deviation of where furniture stood before

std::vector<Segment2> seen_in(const World& world, const SimulationSetting& setting) {
  return cross_section(world, setting.vehicle.simulated.scanner.height_m);
}

/// A piece of each wall now and then is left out.
std::vector<Segment2> without_some(std::span<const Segment2> segments, Random& random) {
  std::vector<Segment2> kept;
  for (const Segment2& segment : segments) {
    const int pieces = std::max(1, static_cast<int>(std::lround(segment.length() / kMissing_m)));
    for (int i = 0; i < pieces; ++i) {
      if (random.uniform() < kMissingShare) continue;
      const Vec2 along = (segment.end - segment.start) / pieces;
      kept.push_back({segment.start + i * along, segment.start + (i + 1) * along});
    }
  }
  return kept;
}

World with_moved_furniture(World world, Random& random) {
  for (Furniture& piece : world.furniture) {
    piece.centre += Vec2(random.normal(kMoved_m), random.normal(kMoved_m));
    piece.heading_rad += random.normal(0.5);
  }
  return world;
}

/// The plan that a mapping program would have made: occupied along what was hit, free where one can get.
PlanReading drawn(std::span<const Segment2> segments, const FreeFloor& floor) {
  const Box2 box = box_around(segments);
  const Vec2 cells = (box.sizes().array() + 2 * kMargin_m) / kCell_m;
  PlanReading map{FloorPlan(static_cast<int>(cells.x()), static_cast<int>(cells.y()), 1), {}};
  FloorPlan& plan = map.plan;
  plan.T_world_plan = {box.min().x() - kMargin_m, box.min().y() - kMargin_m, 0};
  map.unseen.assign(plan.solid.size(), 1);
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) {
      if (!floor.reaches(plan.centre(x, y))) continue;
      plan.solid[plan.index(x, y)] = 0;
      map.unseen[plan.index(x, y)] = 0;
    }
  }
  for (const Segment2& segment : segments) {
    const int steps = static_cast<int>(std::ceil(2 * segment.length() / kCell_m)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p =
          (segment.start + (segment.end - segment.start) * i / steps - plan.T_world_plan.position()) /
          kCell_m;
      const std::size_t cell = plan.index(static_cast<int>(p.x()), static_cast<int>(p.y()));
      plan.solid[cell] = 1;
      map.unseen[cell] = 0;
    }
  }
  return map;
}

}  // namespace

Building building_of_world(const SimulationSetting& setting, const FreeFloor& floor) {
  Building building;
  building.name = setting.world.name;
  const std::vector<Segment2> segments = seen_in(setting.world, setting);
  for (const Segment2& segment : segments) building.walls.walls.push_back({.segment = segment});
  building.floor = FloorGrid(kCell_m);
  const Box2 box = box_around(segments);
  const FloorCell low = building.floor->cell_at(box.min()), high = building.floor->cell_at(box.max());
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (floor.reaches(building.floor->centre({x, y}))) building.floor->set({x, y}, Floor::kFree);
    }
  }
  return building;
}

Result<Building> outdated_map_of_world(const SimulationSetting& setting, const FreeFloor& floor,
                                       Random random, Progress& progress) {
  const World before = with_moved_furniture(setting.world, random);
  const std::vector<Segment2> seen = without_some(seen_in(before, setting), random);
  return building_of_map(drawn(seen, floor), setting.world.name, progress);
}

}  // namespace aisle
