#pragma once

#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/vision/stripes/stripe_fan.hpp"

namespace aisle {

struct ObstacleMemoryParams {
  int sightings_min = 2;
  int free_sightings = 2;
  double join_m = 0.2;
  double kept_s = 8;

  void describe(FieldList& fields);
};

/// What stood in the path in the last images and may stand there still, in the odometry's frame. A place is
/// forgotten when a few images show it free, or when it has not been in view for a while: what the vehicle
/// has come too near to see is not taken for gone at once. No allocation: at most 256 places.
class ObstacleMemory {
 public:
  explicit ObstacleMemory(const ObstacleMemoryParams& params);

  /// Takes in what one image shows in the path.
  /// @param stripe          that has read the image
  /// @param T_odom_vehicle  where the vehicle was when it was taken
  void see(const std::vector<Vec2>& p_vehicle_lit, const StripeFan& stripe, const Pose2& T_odom_vehicle,
           double stamp_s);

  /// The places that count, in the frame of the vehicle at a pose; valid until the next call.
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
