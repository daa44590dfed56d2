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

/// Parks at the end of a taught path, by the vehicle's pose estimate. A vehicle that stopped misaligned backs
/// off along the path and tries again. After the last try it checks whether it is parked well enough; if an
/// obstacle has been put there, a larger lateral offset is allowed.
class PlaceParking {
 public:
  /// @param path  not empty
  PlaceParking(const PlaceParkingParams& params, const VehicleDescription& vehicle, Path path);

  /// Steering angle to follow the path.
  /// @param point  the vehicle's progress on the path
  double steering_rad(const PathPoint& point, const Pose2& T_map_vehicle, double speed_mps,
                      double steering_now_rad) const;

  /// At the path's end: done, failed, or begins to back off.
  /// @param is_taken  an obstacle stands at the vehicle's place: then it may stand beside it
  Decision settle(const Pose2& T_map_vehicle, bool is_taken);
  bool is_backing() const { return back_from_.has_value(); }
  /// Reverses along the path.
  Command back_off(const Pose2& T_map_vehicle, double steering_now_rad) const;
  /// Ends backing off once the vehicle has gone far enough, or can go no farther.
  /// @param free_m  free path behind it
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
