#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/learning/walls/loop_params.hpp"
#include "aisle/learning/walls/scan_tracker.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vision/range_segments.hpp"

namespace aisle {

struct MapParams {
  SegmentParams segments;
  TrackerParams tracker;
  LoopParams loops;
  double dominant_share_min =
      0.3;  ///< scans whose walls give a heading; fewer: the building has no dominant direction
  int adjustment_rounds = 4;
  double drawn_length_m = 0.5;  ///< shorter walls are learned but not drawn
  int drawn_sightings = 3;      ///< nor are walls seen on fewer legs of half a metre of path

  void describe(FieldList& fields);
};

/// Where the vehicle was at every scan after some stage of the work, and the processor time spent up to then.
struct MapStage {
  std::string name;
  std::vector<Pose2> T_map_vehicle;
  std::size_t walls = 0;  ///< in the map at this stage
  double cpu_s = 0;
};

/// What was learned from one log.
struct MapResult {
  WallMap walls;
  std::vector<Pose2> T_map_vehicle;  ///< final, one a scan
  std::vector<Pose2>
      T_map_vehicle_online;  ///< as known when each scan came in, from it and the scans before it only
  std::vector<std::pair<std::size_t, std::size_t>>
      loop_closures;  ///< scans that show the same place: (older, newer)
  double path_m = 0;
  double odometry_delay_s = 0;
  bool has_dominant_direction = false;
  std::vector<MapStage> stages;  ///< filled if `keep_stages`
};

/// Builds a wall map from a log with at least one scan and one odometry sample. The steps: segments from each
/// scan; tracking against the walls around; loops closed between submaps; keyframes and walls adjusted
/// together; every scan laid onto the final walls. `odometry_delay_s`: given, or found from the log.
MapResult build_map(const LaserLog& log, const MapParams& params, std::optional<double> odometry_delay_s,
                    bool keep_stages, Progress& progress);

}  // namespace aisle
