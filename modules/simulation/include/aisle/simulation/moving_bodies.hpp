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

/// Walks to and fro along a path; waits while the vehicle is in the way, and turns back if it stays.
class Walker {
 public:
  explicit Walker(Person person);

  /// Walks on for `time_s`.
  /// @return nullopt until there has been space to appear
  std::optional<MovingBody> step(double now_s, double time_s, const Footprint& footprint,
                                 const Pose2& T_world_vehicle);

 private:
  Pose2 pose_after(double distance_m) const;
  void turn_back();

  Person person_;
  double path_m_ = 0;
  double travelled_m_ = 0;  ///< walked so far, to and fro
  double waited_s_ = 0;
  bool is_there_ = false;
};

/// Everything upright that is not part of the world: people, and the boxes of a scenario. Nothing appears
/// where the vehicle stands until that place is free.
class MovingBodies {
 public:
  explicit MovingBodies(std::span<const Person> people);

  void step(double now_s, double time_s, const ScenarioPlay& play, const Footprint& footprint,
            const Pose2& T_world_vehicle);

  std::span<const MovingBody> all() const { return bodies_; }
  /// The edges of the bodies that are at least this high, moved outwards by a margin.
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
