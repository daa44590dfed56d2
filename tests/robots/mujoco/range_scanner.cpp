#include "range_scanner.hpp"

#include <limits>

#include "model.hpp"

namespace robots {

RangeScanner::RangeScanner(int beams, double range_max_m, unsigned seed)
    : beams_(beams), range_max_m_(range_max_m), random_(seed) {}

std::vector<float> RangeScanner::scan(const Physics& physics) {
  mjtByte groups[mjNGROUP] = {};
  groups[kObstacleGroup] = 1;
  const int site = physics.id(mjOBJ_SITE, "laser");
  const mjtNum* p_world_laser = physics.data()->site_xpos + 3 * site;
  const mjtNum* R_world_laser = physics.data()->site_xmat + 9 * site;
  std::vector<float> ranges;
  for (int beam = 0; beam < beams_; ++beam) {
    const double angle_rad = kFirstAngle_rad + beam * angle_step_rad();
    const mjtNum direction_laser[3] = {std::cos(angle_rad), std::sin(angle_rad), 0};
    mjtNum direction_world[3];
    mju_rotVecMat(direction_world, direction_laser, R_world_laser);
    int hit = -1;
    const double range_m =
        mj_ray(physics.model(), physics.data(), p_world_laser, direction_world, groups, 1, -1, &hit);
    const bool seen = range_m >= kRangeMin_m && range_m <= range_max_m_;
    ranges.push_back(seen ? static_cast<float>(range_m + noise_m_(random_))
                          : std::numeric_limits<float>::infinity());
  }
  return ranges;
}

}  // namespace robots
