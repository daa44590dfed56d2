#include "aisle/maps/wall_map.hpp"

namespace aisle {

double WallMap::length_m() const {
  double sum_m = 0;
  for (const Wall& wall : walls) sum_m += wall.segment.length();
  return sum_m;
}

double WallMap::orthogonal_share() const {
  const double all_m = length_m();
  double orthogonal_m = 0;
  for (const Wall& wall : walls) {
    if (wall.is_orthogonal) orthogonal_m += wall.segment.length();
  }
  return all_m > 0 ? orthogonal_m / all_m : 0;
}

}  // namespace aisle
