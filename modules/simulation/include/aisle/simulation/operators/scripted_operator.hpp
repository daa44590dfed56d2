#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/operators/operator.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

class OperatorPath;

/// How a person drives who knows the route.
struct ScriptedOperatorParams {
  double speed_mps = 0.3;
  double look_ahead_m = 0.7;
  double reaction_s = 0.2;
  double wander_m = 0.05;      ///< standard deviation of the lateral offset
  double wander_time_s = 5;    ///< over which it comes and goes
  double speed_wander = 0.08;  ///< standard deviation, as a share
  double place_radius_m = 0.5;
  double timeout_s = 15;

  void describe(FieldList& fields);
};

/// Follows a world's tour by sight, neither quite straight nor at a quite constant speed, and names the
/// places that it passes. It waits before an obstacle and gives up if that stays. In bends it steers clear of
/// walls as far as there is space, and backs off where it came too near all the same. Where the tour turns
/// back, a differential vehicle turns around. A front-steered one goes on in reverse until it can reverse
/// around a corner and then go on forwards.
class ScriptedOperator final : public Operator {
 public:
  /// @param world  its tour has at least two different points
  ScriptedOperator(const World& world, const VehicleDescription& vehicle,
                   const ScriptedOperatorParams& params, std::uint64_t seed);

  OperatorInput look(const OperatorView& view) override;

  bool has_arrived() const { return leg_ == legs_.size(); }
  /// Legs that are not yet driven to their end.
  std::size_t legs_left() const { return legs_.size() - leg_; }
  /// Share of the route's length that is driven.
  double share_done() const;

 private:
  /// A part of the route that is driven without turning back.
  struct Leg {
    std::vector<Vec2> points;
    double length_m = 0;
    bool in_reverse = false;
  };

  void add_legs(const World& world);
  std::optional<Vec2> place_to_back_to(const Leg& leg, const Vec2& next, OperatorPath& path,
                                       Obstacles& obstacles) const;
  void wander(double time_s);
  OperatorView seen_a_moment_ago(const OperatorView& view);
  void follow(const Vec2& p_world);
  Vec2 target() const;
  Command towards(const Vec2& p_vehicle_target, double speed_mps) const;
  Command clear_of_walls(const Pose2& T_world_vehicle, const Command& requested);
  double wanted_speed_mps(const OperatorView& view) const;
  double cautious_speed_mps(const OperatorView& view, double speed_mps, bool in_reverse) const;
  bool comes_again() const;
  bool is_stuck_at_wall(const OperatorView& view);
  Command back_off(const OperatorView& view);
  std::vector<Mark> passed_places(const Pose2& T_world_vehicle);
  bool has_timed_out(double now_s);

  VehicleDescription vehicle_;
  ScriptedOperatorParams params_;
  Random random_;
  std::vector<Leg> legs_;
  std::vector<NamedPlace> places_;             ///< not passed yet
  Obstacles walls_;                            ///< for the vehicle with some clearance
  std::vector<Obstacles> walls_by_clearance_;  ///< front-steered: with less and less clearance
  std::deque<OperatorView> views_;
  std::size_t leg_ = 0;
  double along_m_ = 0;                                      ///< of the present leg
  std::optional<double> backs_to_m_;                        ///< along it, while backing off from a wall
  double pull_lateral_ = 0, lateral_ = 0, pull_speed_ = 0;  ///< wander, in standard deviations
  std::size_t leg_before_ = 0;                              ///< where it last made progress
  double along_before_m_ = 0;
  double got_on_s_ = 0;
  double stamp_s_ = 0;
};

}  // namespace aisle
