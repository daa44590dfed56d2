#pragma once

#include <optional>
#include <span>

#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/guidance/paths/car_search.hpp"
#include "aisle/guidance/paths/path_driver.hpp"
#include "aisle/guidance/rooms/edge_memory.hpp"

namespace aisle {

struct FrameBackingParams {
  bool wanted = false;
  CarSearchParams search{.margin_m = 0.1};
  SteeringParams steering;
  SpeedParams speed{.speed_mps = 0.2, .speed_min_mps = 0.03, .deceleration_mps2 = 0.05};
  double turn_from_m = 1.8;
  double run_up_m = 1.2;
  double run_up_min_m = 0.4;
  double look_s = 1.5;
  double wait_s = 5;
  int plans_max = 4;
  double lateral_max_m = 0.012;
  double turned_max_rad = 1 * kDegree;
  int tries_max = 3;

  void describe(FieldList& fields);
};

/// Parks a front-steered vehicle backwards in a painted frame: turns it about before the frame, on known free
/// floor, and reverses into it. No camera looks back, so odometry tracks the frame while the vehicle turns.
/// At the end it first reverses up to the frame's far side, from where its cameras see the near side ahead;
/// if it stands misaligned, it drives out and reverses in again.
class FrameBacking {
 public:
  /// @param size_m  of the frame, along the direction of entry and across
  FrameBacking(const FrameBackingParams& params, const VehicleDescription& vehicle, const Vec2& size_m);

  /// Starts planning on this floor: at first, and again when `wants_floor`.
  /// @param floor  in its own frame, which is fixed relative to `odom`
  void begin(FloorGrid floor, const Pose2& T_floor_odom);
  bool has_begun() const { return state_ != State::kNotBegun; }
  /// Adds obstacles seen since then to the floor, except for those that seem to be under the vehicle.
  void see(std::span<const SeenEdge> edges, const Pose2& T_odom_vehicle);

  /// @param T_odom_frame  present estimate of the frame's centre, x along the direction of entry
  Decision step(double stamp_s, const Pose2& T_odom_vehicle, const Pose2& T_odom_frame, double steering_rad);

  /// An obstacle has stayed in its path: `begin` is to be called with the floor as known now.
  bool wants_floor() const { return state_ == State::kBlocked; }
  /// It plans and drives on the floor, and avoids obstacles by itself.
  bool keeps_to_floor() const { return state_ == State::kSearching || state_ == State::kTurning; }
  int tries() const { return tries_; }

 private:
  enum class State {
    kNotBegun,
    kSearching,
    kTurning,
    kBlocked,
    kBackingIn,
    kLooking,
    kComingForward,
    kLeaving
  };

  /// Pose of the parked vehicle: its footprint's centre on the frame's.
  Pose2 T_odom_parked() const;
  Pose2 off() const;
  double deeper_m() const;
  void search_path();
  Decision search();
  Decision turn(double stamp_s);
  Decision blocked();
  Decision back_in(double stamp_s);
  Decision look_back(double stamp_s);
  Decision come_forward();
  Decision leave();
  Decision drive_to(double ahead_of_parked_m, const char* state) const;

  FrameBackingParams params_;
  VehicleDescription vehicle_;
  Vec2 size_m_;
  CarSearch search_;
  PathDriver driver_;
  PathFollower follower_;
  KnownFloor floor_;
  Pose2 T_floor_odom_, T_odom_vehicle_, T_odom_frame_;
  double steering_rad_ = 0;
  double run_up_m_ = 0;
  State state_ = State::kNotBegun;
  double since_s_ = 0;  ///< when it began to look, or was blocked
  bool is_held_up_ = false;
  int plans_ = 0;
  int tries_ = 1;
};

}  // namespace aisle
