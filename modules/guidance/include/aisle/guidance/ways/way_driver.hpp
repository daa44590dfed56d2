#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/ways/braking_room.hpp"
#include "aisle/vehicle/command.hpp"

namespace aisle {

/// Drives a way that was searched on known floor, and never on where the vehicle could not stop in time.
class WayDriver {
 public:
  enum class State {
    kNoWay,
    kArrived,  ///< the way is still there, until it is dropped or goes on
    kTurningWheels,
    kDriving,
    kBlocked,  ///< the command, which was not given, would lead where there is no room
  };
  struct Step {
    State state = State::kNoWay;
    Command command;
    int direction = 0;  ///< forwards 1, backwards -1: how it drives, or would
  };

  WayDriver(const VehicleDescription& vehicle, const SteeringParams& steering, const SpeedParams& speed);
  WayDriver(const WayDriver&) = delete;
  WayDriver& operator=(const WayDriver&) = delete;

  bool has_way() const { return progress_.has_value(); }
  /// Empty where there is no way.
  const Path& path() const { return path_; }
  double left_m() const { return has_way() ? path_.length_m() - progress_->point().along_m : 0; }

  /// @param way  not empty; begins where the way so far ends, or at the vehicle
  void take(const Path& way);
  /// The vehicle's own trail, back as it came: only what it would stand on, or what is struck now, stops it.
  void take_trail(const Path& way);
  /// Keeps at most so much of the way ahead, and no more than the present leg.
  void shorten(double ahead_m);
  void drop();

  /// What the sensor strikes now.
  void see(const LaserScanner& fan, std::span<const float> ranges_m) { braking_.see(fan, ranges_m); }
  bool is_off_struck(const Pose2& T_vehicle_later) const { return braking_.is_off_struck(T_vehicle_later); }

  /// How much of the way ahead is free, by what is known now; all of it: left_m().
  double free_m(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle) const;

  /// @param room  that the vehicle keeps where it can: it slows down where there is less
  /// @param steering_rad  as the wheels stand now
  Step drive(const FloorGrid& floor, const FloorClearance& clearance, const FootprintRoom& room,
             const Pose2& T_map_vehicle, double steering_rad);

 private:
  bool is_free(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
               const Command& command, double steering_rad) const;
  std::optional<double> wheels_to_turn_rad(const PathPoint& point, double followed_rad, double steering_rad);

  VehicleDescription vehicle_;
  SpeedParams speed_;
  FootprintRoom watch_;
  BrakingRoom braking_;
  PathFollower follower_;
  Path path_;
  bool is_on_trail_ = false;
  std::optional<PathProgress> progress_;
  std::size_t leg_begun_ = 0;  ///< end of the leg for which the wheels were turned
};

}  // namespace aisle
