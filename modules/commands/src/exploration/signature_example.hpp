#pragma once

#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "aisle/report/signature_picture.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// C99 Algorithm 2 on one view of a run, which stands where the odometry might have taken it.
struct SignatureExample {
  SignedPattern learned;  ///< the walls about the vehicle
  SignedPattern sensed;   ///< the view, off by `displaced_m`
  Vec2 displaced_m = Vec2::Zero();
  Vec2 found_m = Vec2::Zero();  ///< carries the view onto the walls; right: -displaced_m
};

/// Of the run's views, the one that shows most walls along both axes of the map.
SignatureExample signature_example(const LaserLog& log, const std::vector<Pose2>& T_map_vehicle,
                                   const WallMap& walls, const SegmentParams& segments);

}  // namespace aisle
