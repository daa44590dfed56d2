#include "aisle/maps/wall_direction.hpp"

#include <algorithm>

namespace aisle {

std::optional<WallDirection> walls_around(std::span<const WallDirection> known, const Vec2& p_map,
                                          double reach_m) {
  const auto distance_m = [&](const WallDirection& walls) { return (walls.p_map - p_map).norm(); };
  const auto nearest = std::ranges::min_element(known, {}, distance_m);
  if (nearest == known.end() || distance_m(*nearest) > reach_m) return std::nullopt;
  return *nearest;
}

}  // namespace aisle
