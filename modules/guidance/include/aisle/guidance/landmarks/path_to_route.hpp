#pragma once

#include <vector>

#include "aisle/guidance/obstacles/path_ahead.hpp"
#include "aisle/guidance/paths/car_search.hpp"
#include "aisle/guidance/paths/path_driver.hpp"
#include "aisle/maps/floor_clearance.hpp"

namespace aisle {

/// Brings a vehicle that has found itself beside its route, or facing another way, onto it: back and forth
/// over floor that it has seen while it looked for itself.
class PathToRoute {
 public:
  enum class State {
    kSearching,  ///< stands
    kDriving,
    kThere,  ///< on the route, pointing as it does
    kNoPath,
  };

  /// @param speed  on the way
  /// @param floor  as it is known now, in a frame of its own
  PathToRoute(const VehicleDescription& vehicle, const SteeringParams& steering, const SpeedParams& speed,
              const FloorGrid& floor, const FloorClearance& clearance);

  /// @param T_map_floor  where that frame lies
  /// @param T_map_vehicle  which stands
  void begin(const Path& route, const Pose2& T_map_floor, const Pose2& T_map_vehicle);

  /// Once a cycle.
  /// @param command  standing, unless it drives
  /// @param steering_rad  as the wheels stand now
  State step(const Pose2& T_map_vehicle, double steering_rad, Command& command);

  /// Where it leads next, for whoever watches what comes into the path; empty unless it drives.
  PathAhead ahead(const Pose2& T_map_vehicle, double reach_m) const;

 private:
  bool is_on_route(const Pose2& T_floor_vehicle) const;
  double left_m(const Vec2& p_floor) const;
  State search();

  FloorGrid floor_;
  FloorClearance clearance_;
  CarSearch search_;
  PathDriver driver_;
  Pose2 T_floor_map_;
  std::vector<Pose2> T_floor_route_;  ///< places along it that may be reached
  State state_ = State::kNoPath;
};

}  // namespace aisle
