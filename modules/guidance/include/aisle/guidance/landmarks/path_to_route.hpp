#pragma once

#include <vector>

#include "aisle/guidance/obstacles/path_ahead.hpp"
#include "aisle/guidance/paths/car_search.hpp"
#include "aisle/guidance/paths/path_driver.hpp"
#include "aisle/maps/known_floor.hpp"

namespace aisle {

/// Brings a vehicle that has relocalised off its route, or facing another way, back onto it, over floor that
/// it has explored meanwhile.
class PathToRoute {
 public:
  enum class State {
    kSearching,  ///< the vehicle stands
    kDriving,
    kThere,  ///< on the route, heading along it
    kNoPath,
  };

  /// @param speed  on the path to the route
  /// @param floor  as known now, in its own frame; copied
  PathToRoute(const VehicleDescription& vehicle, const SteeringParams& steering, const SpeedParams& speed,
              const KnownFloor& floor);

  /// @param T_map_floor    pose of that frame
  /// @param T_map_vehicle  pose of the standing vehicle
  void begin(const Path& route, const Pose2& T_map_floor, const Pose2& T_map_vehicle);

  /// Once a cycle.
  /// @param steering_rad  present steering angle
  /// @param command       set; speed 0 unless it drives
  State step(const Pose2& T_map_vehicle, double steering_rad, Command& command);

  /// The path ahead, for an obstacle guard; empty unless it drives.
  PathAhead ahead(const Pose2& T_map_vehicle, double reach_m) const;

 private:
  bool is_on_route(const Pose2& T_floor_vehicle) const;
  double left_m(const Vec2& p_floor) const;
  State search();

  KnownFloor floor_;
  CarSearch search_;
  PathDriver driver_;
  Pose2 T_floor_map_;
  std::vector<Pose2> T_floor_route_;  ///< goal poses along the route
  State state_ = State::kNoPath;
};

}  // namespace aisle
