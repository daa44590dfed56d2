#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/learning/walls/model_updating.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {

/// C99's Algorithms 2 and 3 as published: heading by odometry, translation by one signature match per scan.
/// The two switches add our improvements one at a time, for the table of what each step buys.
struct PublishedParams {
  SignatureParams signature;
  ModelUpdateParams update;
  double axis_tolerance_rad = 15 * kDegree;  ///< segments farther from the axes are left out
  double end_weight = 0.3;  ///< c of Algorithm 2; grows with the occurrences of the end point
  double window_m = 12;     ///< the part L' of the model around the vehicle
  double learned_every_m = 0.2;
  bool heading_from_walls = false;
  bool odometry_prior = false;  ///< displacements that odometry makes unlikely count less
};

/// Poses by odometry alone, in a map whose axes are parallel to the walls of the first scan.
std::vector<Pose2> odometry_poses(const LaserLog& log, const SegmentParams& segments,
                                  double odometry_delay_s);

/// The log's map by the published method; `T_map_vehicle_online` is the trajectory itself.
MapResult build_published_map(const LaserLog& log, const SegmentParams& segments,
                              const PublishedParams& params, double odometry_delay_s, Progress& progress);

}  // namespace aisle
