#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/core/problem.hpp"
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
      0.2;  ///< share of scans whose walls give a heading; with fewer, the building has no dominant direction
  int adjustment_rounds = 4;
  double drawn_length_m = 0.5;  ///< shorter walls are learned but not drawn
  int drawn_sightings = 3;      ///< nor are walls seen on fewer half-metre legs of the path

  void describe(FieldList& fields);
};

/// The vehicle's poses at all scans after one stage of the work, and the processor time spent so far.
struct MapStage {
  std::string name;
  std::vector<Pose2> T_map_vehicle;
  std::size_t walls = 0;  ///< in the map at this stage
  double cpu_s = 0;
};

/// What was learned from one log.
struct MapResult {
  WallMap walls;
  std::vector<Pose2> T_map_vehicle;  ///< final, one per scan
  std::vector<Pose2>
      T_map_vehicle_online;  ///< as known when each scan came in, from that scan and earlier ones only
  std::vector<std::pair<std::size_t, std::size_t>>
      loop_closures;  ///< scans that show the same place: (older, newer)
  double path_m = 0;
  double odometry_delay_s = 0;
  Problems warnings;      ///< where the odometry was not believed, with the line of the recording
  Pose2 T_vehicle_laser;  ///< of the first scanner: as given or as found
  bool has_dominant_direction = false;
  std::vector<MapStage> stages;  ///< filled if `keep_stages`
};

/// What is known of a log beyond its content; what is not is estimated from it.
struct KnownOfLog {
  std::optional<double> odometry_delay_s;
  double guessed_delay_s = 0;   ///< of the odometry, where the walls do not show it
  bool mounting = true;         ///< LaserLog::laser().T_vehicle_laser is where the scanner sits
  bool odometry_noise = false;  ///< the odometry has no more noise than TrackerParams::motion says
};

/// Builds a wall map from a log with at least one scan and one odometry sample. The steps: extract segments
/// from each scan; track them against the walls around; close loops between submaps; adjust keyframes and
/// walls together; fit every scan to the final walls.
MapResult build_map(const LaserLog& log, const MapParams& params, const KnownOfLog& known, bool keep_stages,
                    Progress& progress);

}  // namespace aisle
