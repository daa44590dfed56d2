#pragma once

#include <optional>

#include "aisle/control/path.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct PlaceParkingParams {
  SteeringParams steering{.look_ahead_m = 0.25};
  double lateral_m = 0.05;
  double turned_rad = 1.5 * kDegree;
  double lateral_max_m = 0.1;
  double turned_max_rad = 5 * kDegree;
  double taken_max_m = 0.3;
  double back_off_m = 1.5;
  double back_off_min_m = 0.1;
  double reverse_speed_mps = 0.12;
  int tries_max = 3;

  void describe(FieldList& fields);
};

/// Comes to stand at the end of a path as it was taught, by where the vehicle is known to be: one that came
/// to stand misaligned backs off along the path and comes again. After the last try it says whether it stands
/// well enough: beside what has been put there, it may stand farther off laterally.
class PlaceParking {
 public:
  /// @param path  not empty
  PlaceParking(const PlaceParkingParams& params, const VehicleDescription& vehicle, Path path);

  /// How the wheels should stand to keep to the path.
  /// @param point  where the vehicle is on the path
  double steering_rad(const PathPoint& point, const Pose2& T_map_vehicle, double speed_mps,
                      double steering_now_rad) const;

  /// At the path's end: done, failed, or begins to back off.
  /// @param is_taken  something stands now where the vehicle should: then it need not stand there
  Decision settle(const Pose2& T_map_vehicle, bool is_taken);
  bool is_backing() const { return back_from_.has_value(); }
  /// Backwards along the path.
  Command back_off(const Pose2& T_map_vehicle, double steering_now_rad) const;
  /// Ends backing off once it has gone far enough, or can go no farther.
  /// @param free_m  path that is free behind it
  void judge_path_back(const Pose2& T_map_vehicle, double free_m);

  int tries() const { return tries_; }

 private:
  PlaceParkingParams params_;
  VehicleDescription vehicle_;
  Path path_, path_back_;
  PathFollower follower_;
  std::optional<Pose2> back_from_;  ///< where it began to back off
  int tries_ = 1;
};

}  // namespace aisle
