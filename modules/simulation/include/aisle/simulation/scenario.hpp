#pragma once
/// What goes wrong on a simulated run, and when.

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Something is wrong with a camera, or with the delivery of its images.
struct CameraFault {
  enum class Kind {
    kFrozen,   ///< delivers its last image again and again, with new stamps
    kDark,     ///< sees no light, as under a lens cap
    kDropped,  ///< delivers nothing
    kLate,     ///< delivers images some time later, with their true stamps
  };
  Kind kind = Kind::kFrozen;
  std::string camera;  ///< empty: all of them
  double delay_s = 0.5;
};

/// The wheels turn farther than the vehicle goes.
struct SlipBurst {
  double spin = 1;  ///< share of the distance counted too much
};

/// The front wheels suddenly stand this much farther left than the steering encoder says.
struct SteeringBias {
  double bias_rad = 3 * kDegree;
};

/// A box blocks the path.
struct BlockingBox {
  Pose2 T_world_box;
  Vec2 size = Vec2(0.5, 0.5);  ///< along its x and y
  double height_m = 1;
};

/// Somebody walks to and fro.
struct CrossingPerson {
  Person person;  ///< its start_s counts from the event
};

/// The vehicle is kidnapped: somebody lifts it and puts it down elsewhere.
struct Lifted {
  Pose2 T_world_vehicle;
};

/// The line lasers are off.
struct LaserOff {};

/// Day, dusk, lamps switched off.
struct LightChange {
  double light = 0.3;  ///< all light times this
  bool lamps_on = true;
};

using Fault = std::variant<CameraFault, SlipBurst, SteeringBias, BlockingBox, CrossingPerson, Lifted,
                           LaserOff, LightChange>;

struct ScenarioEvent {
  Fault fault;
  double from_s = 0;         ///< begins at this time,
  std::optional<Vec2> near;  ///< or, if given, as soon after that as the vehicle's base_link is near here
  double radius_m = 1;       ///< at most this far from `near`
  double duration_s = std::numeric_limits<double>::infinity();
};

struct Scenario {
  std::string name;
  std::string world;  ///< the world that its places are in; empty: any
  std::vector<ScenarioEvent> events;
};

}  // namespace aisle
