#pragma once
/// Compares what a simulated exploration learned with the ground truth. No navigator ever sees any of this.

#include <vector>

#include "aisle/evaluation/exploration/sensor_view.hpp"
#include "aisle/evaluation/exploration/wall_errors.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/maps/corridor_graph.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What was driven and learned.
struct DrivenExploration {
  const std::vector<Pose2>&
      T_world_vehicle;  ///< true poses, one per cycle; not empty; the first is the start
  Pose2 T_world_map;    ///< the learned map's frame in the world, see map_in_world()
  const FloorGrid& floor;
  const WallMap& walls;
};

/// Share of the coverable floor that a complete mission has covered. The rest is corners behind which too
/// little floor lies to look for.
inline constexpr double kCompleteShare = 0.98;

struct ExplorationScore {
  double coverable_m2 = 0;   ///< floor that the sensor can see from a pose that the footprint can reach
  double covered_share = 0;  ///< share of that floor that was in the sensor's view during the run
  double mapped_share = 0;   ///< share of that floor that is known in the learned floor
  double home_error_m = 0;   ///< distance from true start to true end
  double home_error_rad = 0;
  WallErrors walls;          ///< only of walls that the sensor can see from a reachable pose
  double graph_bound_m = 0;  ///< twice the length of all true corridors
};

/// Least clearance of the footprint from obstacles for a gap to count as passable.
inline constexpr double kPassableMargin_m = 0.05;

ExplorationScore evaluate_exploration(const World& world, const VehicleDescription& vehicle,
                                      const SensorField& sensor, const DrivenExploration& driven);

/// Pose of a learned map's frame in the world: the least-squares rigid alignment of the learned path with the
/// true one. The map has a frame of its own, so that only its distortion counts as an error. Both paths have
/// the same time stamps.
Pose2 map_in_world(const std::vector<Pose2>& T_map_vehicle, const std::vector<Pose2>& T_world_vehicle);

/// The true graph of the corridors that a vehicle can drive from a start, in the world frame.
CorridorGraph true_corridors(const World& world, const VehicleDescription& vehicle,
                             const Vec2& p_world_start);

}  // namespace aisle
