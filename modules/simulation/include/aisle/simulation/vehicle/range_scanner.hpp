#pragma once

#include <span>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/wall_grid.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Faults of a simulated scanner that the vehicle does not know of. The defaults are an ordinary scanner.
struct RangeSensorParams {
  int beams = 180;
  double noise_sigma_m = 0.01;
  double angle_offset_rad = 0;
  double resolution_m = 0.01;
  double dropped_share = 0.002;
  double height_m = 0.3;

  void describe(FieldList& fields);
};

/// A 2-D range scanner and its faults.
struct RangeScannerParams {
  LaserScanner laser = kOneReadingADegree;  ///< as the vehicle knows it
  RangeSensorParams sensor;

  void describe(FieldList& fields) {
    laser.describe(fields);
    sensor.describe(fields);
  }
};

/// Measures a world by ray casting.
class RangeScanner {
 public:
  RangeScanner(const World& world, const RangeScannerParams& params);

  /// What the vehicle believes of its scanner: everything but the faults.
  const LaserScanner& description() const { return params_.laser; }

  /// One reading per beam [m]; range_max_m: nothing seen.
  /// @param movers  outlines of what is not part of the world
  std::vector<float> scan(const Pose2& T_world_vehicle, Random& random,
                          std::span<const Segment2> movers = {}) const;

 private:
  RangeScanner(const RangeScannerParams& params, SeenOutlines outlines);
  double seen_m(const Vec2& p_world_laser, const Vec2& direction, Random& random) const;
  double reading_m(double true_m, Random& random) const;

  RangeScannerParams params_;
  WallGrid walls_;
  std::vector<FaintOutline> faint_;
};

}  // namespace aisle
