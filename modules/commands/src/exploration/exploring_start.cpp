#include "exploration/exploring_start.hpp"

#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/simulation/obstacles.hpp"

namespace aisle {
namespace {

constexpr double kPath_m = 2;
constexpr int kHeadings = 16;

std::optional<Pose2> turned_to_a_path(Obstacles& obstacles, const Pose2& T_world_vehicle) {
  for (int i = 0; i < kHeadings; ++i) {
    const Pose2 turned = T_world_vehicle * Pose2{0, 0, i * 2 * kPi / kHeadings};
    if (!obstacles.touch(turned) && obstacles.free_share(turned, {.length_m = kPath_m}) == 1) return turned;
  }
  return std::nullopt;
}

}  // namespace

Pose2 start_with_a_path(const World& world, const Footprint& footprint, const Pose2& T_world_start) {
  Obstacles obstacles(world, footprint);
  if (const auto turned = turned_to_a_path(obstacles, T_world_start)) return *turned;
  for (const Vec2& p_world : world.tour) {
    const Pose2 T_world_tour{p_world.x(), p_world.y(), T_world_start.theta};
    if (const auto turned = turned_to_a_path(obstacles, T_world_tour)) return *turned;
  }
  return T_world_start;
}

}  // namespace aisle
