#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/operators/tour_driver.hpp"
#include "aisle/simulation/paths/clearance_grid.hpp"

namespace aisle {

/// A run of the tour driver along a world's tour.
struct DrivenTour {
  bool arrived = false;
  double clearance_min_m =
      std::numeric_limits<double>::infinity();  ///< of its centre, at most 8 cm too small
};

/// @param look_ahead_m  how much of each corner is cut
inline DrivenTour drive_tour(const World& world, double look_ahead_m = 0.5) {
  const ClearanceGrid grid(obstacles_below(world, 2), 0.04);
  TourDriver driver(world.tour, {.look_ahead_m = look_ahead_m});
  DrivenTour driven;
  for (int step = 0; step < 100'000 && !driver.has_arrived(); ++step) {
    driver.step(0.2);
    driven.clearance_min_m = std::min(driven.clearance_min_m, grid.clearance_m(driver.pose().position()));
  }
  driven.arrived = driver.has_arrived();
  return driven;
}

}  // namespace aisle
