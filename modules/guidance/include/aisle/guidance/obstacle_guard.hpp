#pragma once
/// Keeps any navigator from driving against something.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "aisle/guidance/obstacle_memory.hpp"
#include "aisle/guidance/picture_watch.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/standing_things.hpp"

namespace aisle {

struct ObstacleGuardParams {
  StandingThingParams things;
  ObstacleMemoryParams memory;
  PictureWatchParams pictures;
  double margin_m = 0.08;
  double gap_m = 0.2;
  double reach_m = 4;
  double deceleration_share = 0.5;
  double reaction_s = 0.4;
  double reverse_speed_mps = 0.15;
  double free_again_s = 0.8;
  double wait_max_s = 20;

  void describe(FieldList& fields);
};

enum class GuardState {
  kFree,     ///< the wished command, or slower because something is ahead
  kWaiting,  ///< stands until the way is free or the camera is back
  kBlocked,  ///< has waited too long, or touches something: the navigator should give up or turn back
};

struct Guarded {
  Command command;
  GuardState state = GuardState::kFree;
  std::string why;  ///< one line for people; empty while nothing is in the way
  double free_ahead_m =
      0;  ///< along the arc of the wished command, at most `reach_m`; 0 if it cannot be known
};

/// Stands between a navigator and the vehicle. Sees what stands on the floor with the vehicle's range scanner
/// and one of its cameras, as far as it has them, remembers it while the vehicle comes too near to see it,
/// and lets the vehicle go only as fast as it can stop before the first thing on the arc of the wished
/// command. Nothing sees behind: reversing is slow, and the bumper ends it. What was never in view (the floor
/// before a camera that looks far ahead, at the start) counts as free, as somebody has put the vehicle there.
class ObstacleGuard {
 public:
  /// @param camera  the name of the camera to look with; empty: the first one, if there is any
  /// @throws std::invalid_argument if there is no such camera or it sees no floor, or if the vehicle has
  /// neither
  ///         camera nor scanner
  ObstacleGuard(const VehicleDescription& vehicle, const ObstacleGuardParams& params,
                const std::string& camera = {});

  /// Once a cycle.
  Guarded guard(const Observation& observation, const Command& wished);

  /// The things that count now, in the vehicle's frame; for drawings.
  const std::vector<Vec2>& places() const { return p_vehicle_; }

 private:
  struct StampedPose {
    double stamp_s = 0;
    Pose2 T_odom_vehicle;
  };
  struct Eye {
    StandingThingDetector detector;
    PictureWatch watch;
  };

  void move(const Observation& observation);
  Pose2 pose_at(double stamp_s) const;
  void look(const Observation& observation);
  void take_scan(const RangeScan& scan);
  bool is_remembered_right_ahead() const;
  bool is_hidden_right_ahead(const std::vector<StandingThing>& things) const;
  double free_ahead_m(const Command& wished) const;
  double speed_before(double free_m) const;
  Command limited(const Command& wished) const;
  Guarded waiting(double now_s, std::string why);

  VehicleDescription vehicle_;
  ObstacleGuardParams params_;
  std::optional<Eye> eye_;
  ObstacleMemory memory_;
  std::array<StampedPose, 16> poses_;
  std::size_t moves_ = 0;
  Pose2 T_odom_vehicle_;
  std::vector<Vec2> p_vehicle_;
  int hidden_pictures_ = 0;  ///< in a row that show something right ahead whose foot is not in view
  std::optional<double> waiting_from_s_;
  double free_from_s_ = 0;
};

}  // namespace aisle
