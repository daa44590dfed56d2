#pragma once

#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "aisle/report/signature_picture.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// C99 Algorithm 2 on one view of a run, displaced as the odometry might have displaced it.
struct SignatureExample {
  SignedPattern learned;  ///< the walls around the vehicle
  SignedPattern sensed;   ///< the view, displaced by `displaced_m`
  Vec2 displaced_m = Vec2::Zero();
  Vec2 found_m = Vec2::Zero();  ///< shift that moves the view onto the walls; exact: -displaced_m
};

/// Takes the view of the run that shows most wall along both axes of the map.
SignatureExample signature_example(const LaserLog& log, const std::vector<Pose2>& T_map_vehicle,
                                   const WallMap& walls, const SegmentParams& segments);

}  // namespace aisle
