#include "random_start.hpp"

#include <fmt/format.h>

#include "aisle/core/random.hpp"
#include "aisle/geometry/box2.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {
namespace {

constexpr double kBeside_m = 0.15;   // whoever puts a vehicle down leaves it so much space on all sides
constexpr double kPassable_m = 0.3;  // radius of what must get through, for floor to count as reached
constexpr int kTries = 20000;

Footprint with_space(Footprint footprint, double ahead_m) {
  footprint.front_m += ahead_m;
  footprint.rear_m += kBeside_m;
  footprint.width_m += 2 * kBeside_m;
  return footprint;
}

Problem no_space(const SimulationSetting& setting, double ahead_m) {
  const Footprint& footprint = setting.vehicle.description.footprint;
  return {{setting.world_file.string(), 0, "walls"},
          fmt::format("leave no space for a random start, in {} tries: a vehicle of {:.2f} x {:.2f} m needs "
                      "{:.2f} m ahead and {:.2f} m on its other sides, on floor that it reaches from the "
                      "world's start; take a wider world or a smaller vehicle",
                      kTries, footprint.front_m + footprint.rear_m, footprint.width_m, ahead_m, kBeside_m)};
}

}  // namespace

Result<Pose2> random_start(const SimulationSetting& setting, double ahead_m, std::uint64_t seed) {
  const auto start = start_in(setting);
  if (!start) return start.problems();
  const Footprint needed = with_space(setting.vehicle.description.footprint, ahead_m);
  const FreeFloor floor(obstacles_below(setting.world, needed.height_m), start->position(), kPassable_m);
  const Box2 box = box_around(cross_section(setting.world, setting.vehicle.simulated.scanner.height_m));
  Random random(seed ^ 0x10ca1);
  for (int i = 0; i < kTries; ++i) {
    const Pose2 T_world{random.uniform(box.min().x(), box.max().x()),
                        random.uniform(box.min().y(), box.max().y()), random.uniform(-kPi, kPi)};
    if (floor.reaches(T_world.position()) && fits(setting.world, needed, T_world)) return T_world;
  }
  return no_space(setting, ahead_m);
}

}  // namespace aisle
