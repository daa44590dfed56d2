#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/scenario_play.hpp"
#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A body's edges on the floor, its outside on their left.
std::vector<Segment2> outline(const MovingBody& body);

/// Walks there and back along a path; waits while the vehicle is in the path, and turns back when it stays.
class Walker {
 public:
  explicit Walker(Person person);

  /// Goes on for a short time.
  /// @return nullopt until there has been room to appear
  std::optional<MovingBody> step(double now_s, double time_s, const Footprint& footprint,
                                 const Pose2& T_world_vehicle);

 private:
  Pose2 pose_after(double path_m) const;
  void turn_back();

  Person person_;
  double path_m_ = 0;
  double travelled_m_ = 0;  ///< walked so far, there and back
  double waited_s_ = 0;
  bool is_there_ = false;
};

/// Everything upright that is not part of the world: people, and what a scenario puts down. Nothing appears
/// where the vehicle stands before that place is free.
class MovingBodies {
 public:
  explicit MovingBodies(std::span<const Person> people);

  void step(double now_s, double time_s, const ScenarioPlay& play, const Footprint& footprint,
            const Pose2& T_world_vehicle);

  std::span<const MovingBody> all() const { return bodies_; }
  /// The edges of those that are at least so high, moved outwards by a margin.
  std::vector<Segment2> outlines(double height_m = 0, double margin_m = 0) const;

 private:
  void step_event(std::size_t event, double now_s, double time_s, const ScenarioPlay& play,
                  const Footprint& footprint, const Pose2& T_world_vehicle);

  std::vector<Walker> people_;
  std::map<std::size_t, Walker> crossing_;   ///< by event
  std::map<std::size_t, MovingBody> boxes_;  ///< by event
  std::vector<MovingBody> bodies_;
};

}  // namespace aisle
