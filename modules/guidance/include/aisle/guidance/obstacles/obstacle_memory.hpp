#pragma once

#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/vision/stripes/stripe_scan.hpp"

namespace aisle {

struct ObstacleMemoryParams {
  int sightings_min = 2;
  int free_sightings = 2;
  double join_m = 0.2;
  double kept_s = 8;

  void describe(FieldList& fields);
};

/// Obstacles that the last images showed in the path, in the odometry frame. One is forgotten when a few
/// images show its place free, or when it has not been seen for a while: an obstacle that has become too near
/// to be seen must not be taken for gone at once. Holds at most 256 places, without allocation.
class ObstacleMemory {
 public:
  explicit ObstacleMemory(const ObstacleMemoryParams& params);

  /// Takes in the laser returns that one image shows in the path.
  /// @param stripe          has read that image
  /// @param T_odom_vehicle  vehicle pose when it was taken
  void see(const std::vector<Vec2>& p_vehicle_returns, const StripeScan& stripe, const Pose2& T_odom_vehicle,
           double stamp_s);

  /// The obstacles seen often enough, in the frame of the vehicle at a pose; valid until the next call.
  const std::vector<Vec2>& places(const Pose2& T_odom_vehicle);

 private:
  struct Place {
    Vec2 p_odom = Vec2::Zero();
    double seen_s = 0;
    int sightings = 0;
    int free_sightings = 0;
  };

  void remember(const Vec2& p_odom, double stamp_s);

  ObstacleMemoryParams params_;
  std::vector<Place> places_;
  std::vector<Vec2> p_vehicle_;
};

}  // namespace aisle
