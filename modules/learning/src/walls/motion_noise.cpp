#include "aisle/learning/walls/motion_noise.hpp"

#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kMoving_m = 0.002;
constexpr double kMoving_rad = 0.002;
constexpr double kStanding_m2 = 1e-6;
constexpr double kStanding_rad2 = 1e-7;
constexpr double kSidewaysShare = 0.5;  // share of the forward variance: wheels slip less sideways

}  // namespace

void MotionNoise::describe(FieldList& fields) {
  fields.real("distance_m_per_sqrt_m", distance_m_per_sqrt_m, {0.001, 1},
              "standard deviation of the distance after 1 m");
  fields.real("distance_scale", distance_scale, {0, 0.1},
              "relative error of all counted distances, estimated online; 0: none");
  fields.real("rotation_rad_per_sqrt_m", rotation_rad_per_sqrt_m, {0.001, 1},
              "standard deviation of the heading after 1 m");
  fields.real("rotation_rad_per_sqrt_rad", rotation_rad_per_sqrt_rad, {0, 1},
              "the same after turning by 1 rad");
  fields.real("rotation_share", rotation_share, {0, 1}, "standard deviation as a share of a step's rotation");
  fields.real("moving_floor_m", moving_floor_m, {0, 0.1}, "least standard deviation of a step that moves");
  fields.real("moving_floor_rad", moving_floor_rad, {0, 0.1}, "the same for the heading");
}

Mat3 MotionNoise::covariance(const Pose2& step) const {
  const double distance_m = std::hypot(step.x, step.y);
  const double turn_rad = std::abs(step.theta);
  double ahead_m2 = square(distance_m_per_sqrt_m) * distance_m + kStanding_m2;
  double turn_rad2 = square(rotation_rad_per_sqrt_m) * distance_m +
                     square(rotation_rad_per_sqrt_rad) * turn_rad + square(rotation_share * turn_rad) +
                     kStanding_rad2;
  if (distance_m > kMoving_m) ahead_m2 += square(moving_floor_m);
  if (distance_m > kMoving_m || turn_rad > kMoving_rad) turn_rad2 += square(moving_floor_rad);
  return Vec3(ahead_m2, kSidewaysShare * ahead_m2, turn_rad2).asDiagonal();
}

}  // namespace aisle
