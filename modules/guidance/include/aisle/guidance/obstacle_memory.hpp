#pragma once

#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/vision/standing_things.hpp"

namespace aisle {

struct ObstacleMemoryParams {
  int sightings_min = 3;
  int free_sightings = 3;
  double join_m = 0.15;
  double kept_s = 30;
  double kept_m = 6;

  void describe(FieldList& fields);
};

/// What stood on the floor in the last pictures and may stand there still, in the odometry's frame. A place
/// is forgotten when the floor has been seen there a few times, when it is far away, or after a long time:
/// what the vehicle has come too near to see is not taken for gone. No allocation: at most 256 places.
class ObstacleMemory {
 public:
  explicit ObstacleMemory(const ObstacleMemoryParams& params);

  /// Takes in what one picture shows.
  /// @param T_odom_vehicle  where the vehicle was when it was taken
  void see(const std::vector<StandingThing>& things, const StandingThingDetector& detector,
           const Pose2& T_odom_vehicle, double stamp_s);

  /// The places that count, in the frame of the vehicle at a pose; valid until the next call.
  const std::vector<Vec2>& places(const Pose2& T_odom_vehicle);

 private:
  struct Place {
    Vec2 p_odom = Vec2::Zero();
    double seen_s = 0;
    int sightings = 0;
    int free_sightings = 0;
  };

  void remember(const StandingThing& thing, const Pose2& T_odom_vehicle, double stamp_s);

  ObstacleMemoryParams params_;
  std::vector<Place> places_;
  std::vector<Vec2> p_vehicle_;
};

}  // namespace aisle
