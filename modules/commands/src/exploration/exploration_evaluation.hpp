#pragma once
/// How well a simulated exploration knew its building in the end, by the truth. Nothing of this is ever seen
/// by a navigator.

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/maps/corridor_graph.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "exploration/sensor_view.hpp"
#include "exploration/wall_errors.hpp"

namespace aisle {

/// What was driven and learned.
struct DrivenExploration {
  const std::vector<Pose2>& T_world_vehicle;  ///< true, one a cycle; the first is the start; not empty
  Pose2 T_world_map;                          ///< how the learned map lies in the world, see map_in_world()
  const FloorGrid& floor;
  const WallMap& walls;
};

struct ExplorationScore {
  double coverable_m2 = 0;   ///< floor that the sensor can see from some pose that the footprint can get to
  double covered_share = 0;  ///< of that floor: was in the sensor's view on the way that was driven
  double mapped_share = 0;   ///< of that floor: is known in the learned floor
  double home_error_m = 0;   ///< true end against true start
  double home_error_rad = 0;
  WallErrors walls;          ///< only walls that the sensor can see from where the footprint can get
  double graph_bound_m = 0;  ///< twice the length of all true corridors
};

/// How far a vehicle's footprint keeps from what stands there at least, for a gap to count as passable.
inline constexpr double kPassableMargin_m = 0.05;

ExplorationScore evaluate_exploration(const World& world, const VehicleDescription& vehicle,
                                      const SensorField& sensor, const DrivenExploration& driven);

/// How a learned map lies in the world: the turn and shift that bring the learned path onto the true one
/// (least squares). The map's frame is its own: only what is bent in it counts as an error. The two are of
/// the same moments.
Pose2 map_in_world(const std::vector<Pose2>& T_map_vehicle, const std::vector<Pose2>& T_world_vehicle);

/// The corridors that a vehicle can drive from a place, by the truth, in `world`.
CorridorGraph true_corridors(const World& world, const VehicleDescription& vehicle,
                             const Vec2& p_world_start);

}  // namespace aisle
