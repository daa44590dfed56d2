#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/vehicle/camera_description.hpp"
#include "aisle/vehicle/differential.hpp"
#include "aisle/vehicle/front_steered.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The space that a vehicle takes up: a rectangle about base_link, and its height.
struct Footprint {
  double front_m = 0.75;  ///< ahead of base_link
  double rear_m = 0.25;   ///< behind it
  double width_m = 0.6;   ///< left and right together
  double height_m = 1.2;

  void describe(FieldList& fields);
};

/// Distance from the footprint's outline to a point of base_link [m]; negative inside.
inline double off_footprint_m(const Footprint& footprint, const Vec2& p_vehicle) {
  const double along_m = std::max(p_vehicle.x() - footprint.front_m, -footprint.rear_m - p_vehicle.x());
  const double across_m = std::abs(p_vehicle.y()) - footprint.width_m / 2;
  if (along_m > 0 && across_m > 0) return std::hypot(along_m, across_m);
  return std::max(along_m, across_m);
}

/// Limits that the vehicle keeps, whatever it is commanded.
struct DriveLimits {
  double speed_max_mps = 1.0;
  double reverse_speed_max_mps = 0.5;
  double acceleration_max_mps2 = 0.5;
  double deceleration_max_mps2 = 1.5;
  double steering_max_rad = 40 * kDegree;               ///< front-steered
  double steering_rate_max_rad_s = 60 * kDegree;        ///< front-steered
  double turn_rate_max_rad_s = 90 * kDegree;            ///< differential
  double turn_acceleration_max_rad_s2 = 180 * kDegree;  ///< differential
  double command_age_max_s = 0.5;                       ///< older commands mean: stop

  void describe(FieldList& fields);
};

/// Line lasers that draw a stripe on everything at one height (C99 section 3.1: laser markers).
struct LaserMarkers {
  double height_m = 0.3;  ///< h0, of the light plane above the floor

  void describe(FieldList& fields);
};

/// What a vehicle is: how it moves, how accurate its odometry is, and what sensors it has.
struct VehicleDescription {
  std::string name = "vehicle";
  bool is_differential = false;  ///< else front-steered; the parts of the other kind are not used
  FrontSteered front_steered;
  FrontSteeredNoise front_steered_noise;
  Differential differential;
  DifferentialNoise differential_noise;
  Footprint footprint;
  DriveLimits limits;
  double cycle_s = 0.1;  ///< from one observation to the next
  std::vector<CameraDescription> cameras;
  std::optional<LaserScanner> scanner;
  std::optional<LaserMarkers> laser_markers;

  /// The camera of this name; nullptr: there is none.
  const CameraDescription* camera(std::string_view called) const;

  /// Everything but name, cameras, scanner and line lasers, which are optional.
  void describe(FieldList& fields);
};

}  // namespace aisle
