#include "random_start.hpp"

#include "aisle/core/random.hpp"
#include "aisle/geometry/box2.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {
namespace {

constexpr double kBeside_m = 0.15;   // whoever puts a vehicle down leaves it so much space on all sides
constexpr double kPassable_m = 0.3;  // radius of what must get through, for floor to count as reached
constexpr int kTries = 20000;

}  // namespace

Result<Pose2> random_start(const SimulationSetting& setting, double ahead_m, std::uint64_t seed) {
  const auto start = start_in(setting);
  if (!start) return start.problems();
  Footprint needed = setting.vehicle.description.footprint;
  const FreeFloor floor(obstacles_below(setting.world, needed.height_m), start->position(), kPassable_m);
  const Box2 box = box_around(cross_section(setting.world, setting.vehicle.simulated.scanner.height_m));
  needed.front_m += ahead_m;
  needed.rear_m += kBeside_m;
  needed.width_m += 2 * kBeside_m;
  Random random(seed ^ 0x10ca1);
  for (int i = 0; i < kTries; ++i) {
    const Pose2 T_world{random.uniform(box.min().x(), box.max().x()),
                        random.uniform(box.min().y(), box.max().y()), random.uniform(-kPi, kPi)};
    if (floor.reaches(T_world.position()) && fits(setting.world, needed, T_world)) return T_world;
  }
  return *start;
}

}  // namespace aisle
