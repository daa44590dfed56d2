#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/paths/braking_clearance.hpp"
#include "aisle/vehicle/command.hpp"

namespace aisle {

/// Follows a path planned on known floor, and never drives where the vehicle could not stop in time.
class PathDriver {
 public:
  enum class State {
    kNoPath,
    kArrived,  ///< the path is kept until it is dropped or continued
    kTurningWheels,
    kDriving,
    kBlocked,  ///< the vehicle stands: it could not go on without a collision
  };
  struct Step {
    State state = State::kNoPath;
    Command command;
    std::optional<LegDirection> direction = {};  ///< in which it drives, or would; known when driving or
                                                 ///< blocked
  };

  PathDriver(const VehicleDescription& vehicle, const SteeringParams& steering, const SpeedParams& speed);
  PathDriver(const PathDriver&) = delete;
  PathDriver& operator=(const PathDriver&) = delete;

  bool has_path() const { return progress_.has_value(); }
  /// Empty if there is none.
  const Path& path() const { return path_; }
  /// Path left to its end; 0 without a path.
  double left_m() const { return has_path() ? path_.length_m() - progress_->point().along_m : 0; }

  /// @param path     not empty; begins where the present path ends, or at the vehicle
  /// @param trail_m  the last part of it leads along the vehicle's own trail: only occupied floor under its
  ///                 footprint, or present laser returns, stop it there
  void take(const Path& path, double trail_m = 0);
  /// Drives back along the vehicle's own trail.
  void take_trail(const Path& path);
  /// Keeps at most `ahead_m` of the path ahead, and no more than the present leg.
  void shorten(double ahead_m);
  void drop();

  /// Takes in the present scan.
  void see(const LaserScanner& scanner, std::span<const float> ranges_m) { braking_.see(scanner, ranges_m); }
  bool is_off_hit(const Pose2& T_vehicle_later) const { return braking_.is_off_hit(T_vehicle_later); }

  /// How much of the path ahead is free, by what is known now; at most left_m().
  double free_m(const KnownFloor& floor, const Pose2& T_map_vehicle) const;

  /// @param footprint_clearance  has the margin that the vehicle should keep; with less it slows down
  /// @param steering_rad         present steering angle
  Step drive(const KnownFloor& floor, const FootprintClearance& footprint_clearance,
             const Pose2& T_map_vehicle, double steering_rad);

 private:
  static constexpr double kNoTrail_m = std::numeric_limits<double>::infinity();

  bool is_on_trail() const { return progress_->point().along_m >= trail_from_m_; }
  bool is_free(const KnownFloor& floor, const Pose2& T_map_vehicle, const Command& command,
               double steering_rad) const;
  std::optional<double> wheels_to_turn_rad(const PathPoint& point, double followed_rad, double steering_rad);

  VehicleDescription vehicle_;
  SpeedParams speed_;
  FootprintClearance kept_clearance_;
  BrakingClearance braking_;
  PathFollower follower_;
  Path path_;
  double trail_from_m_ = kNoTrail_m;  ///< along the path
  std::optional<PathProgress> progress_;
  std::size_t leg_begun_ = 0;  ///< end of the leg for which the wheels were turned last
};

}  // namespace aisle
