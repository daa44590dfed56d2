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

/// Turns a front-steered vehicle about before a painted frame that it has seen, on floor that is known to be
/// free, and drives it backwards into the frame. No camera looks back: while it turns, odometry carries the
/// frame. Before it comes to stand it backs up to the frame's far side, from where its cameras show the near
/// side ahead of it; if it stands misaligned, it drives out and backs in again.
class FrameBacking {
 public:
  /// @param size_m  of the frame, along the path in and across
  FrameBacking(const FrameBackingParams& params, const VehicleDescription& vehicle, const Vec2& size_m);

  /// @param floor  in a frame of its own, which stays where it is against `odom`
  void begin(FloorGrid floor, const Pose2& T_floor_odom);
  bool has_begun() const { return state_ != State::kNotBegun; }
  /// Takes in what was seen to stand on the floor since, but for what seems to be under the vehicle.
  void see(std::span<const SeenEdge> edges, const Pose2& T_odom_vehicle);

  /// @param T_odom_frame  x along the path in, as it is known now
  Decision step(double stamp_s, const Pose2& T_odom_vehicle, const Pose2& T_odom_frame, double steering_rad);

  /// Something has stayed in its path: it is to begin again, with the floor as it is known now.
  bool wants_floor() const { return state_ == State::kBlocked; }
  /// It is led by the floor, and keeps off what stands there.
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

  /// Where it is to stand, with the footprint's middle on the frame's.
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
  FloorGrid floor_;
  FloorClearance clearance_;
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
