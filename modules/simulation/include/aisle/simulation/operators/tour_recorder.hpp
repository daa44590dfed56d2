#pragma once

#include <cstdint>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/simulation/operators/tour_driver.hpp"
#include "aisle/simulation/vehicle/range_scanner.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Errors of the wheel odometry. The defaults are an ordinary indoor robot: some percent of the distance, and
/// several degrees in ten metres.
struct OdometryNoiseParams {
  double distance_error = 0.025;
  double slip_sigma_m = 0.02;
  double rotation_error = 0.02;
  double drift_rad_per_m = 0.4 * kDegree;
  double drift_sigma_rad = 0.5 * kDegree;
  double rotation_sigma_rad = 1 * kDegree;

  void describe(FieldList& fields) {
    fields.real("distance_error", distance_error, {-0.5, 0.5}, "share of every distance counted too much");
    fields.real("slip_sigma_m", slip_sigma_m, {0, 1},
                "standard deviation of the distance after 1 m, grows as the root");
    fields.real("rotation_error", rotation_error, {-0.5, 0.5}, "share of every rotation counted too much");
    fields.angle("drift_deg_per_m", drift_rad_per_m, {-20, 20},
                 "rotation counted in every metre driven straight");
    fields.angle("drift_sigma_deg", drift_sigma_rad, {0, 20}, "standard deviation of the heading after 1 m");
    fields.angle("rotation_sigma_deg", rotation_sigma_rad, {0, 20},
                 "standard deviation of a turn of one radian");
  }
};

struct TourParams {
  double scan_period_s = 0.2;
  double odometry_delay_s = 0;
  TourDriverParams driver;
  OdometryNoiseParams odometry;
  RangeScannerParams scanner;

  void describe(FieldList& fields) {
    fields.real("scan_period_s", scan_period_s, {0.01, 10}, "from one scan to the next");
    fields.real("odometry_delay_s", odometry_delay_s, {-2, 2},
                "the odometry written with a scan is from this much later");
    fields.group("driver", driver);
    fields.group("odometry", odometry);
    fields.group("scanner", scanner);
  }
};

/// A log as a vehicle would have recorded it, and what only a simulator knows.
struct TourRecording {
  LaserLog log;                        ///< one odometry sample per scan, with the same stamp
  std::vector<Pose2> T_world_vehicle;  ///< the true pose at each scan
};

/// Drives the world's tour (at least two different waypoints) once. The same arguments give the same bytes.
TourRecording record_tour(const World& world, const TourParams& params, std::uint64_t seed,
                          Progress& progress);

}  // namespace aisle
