#pragma once
/// Every key that an event of a scenario file may use, fault by fault.

#include <string_view>

#include "aisle/simulation/scenario.hpp"
#include "worlds/world_fields.hpp"

namespace aisle {

/// When and where an event is active. `near` is set only if the file has that key.
struct EventTimes {
  double from_s = 0;
  double for_s = 0;  ///< 0: for ever
  Vec2 near = Vec2::Zero();
  double radius_m = 1;
};

ObjectFields fields_of(EventTimes& times);

ObjectFields fields_of(CameraFault& fault);
ObjectFields fields_of(SlipBurst& fault);
ObjectFields fields_of(SteeringBias& fault);
ObjectFields fields_of(BlockingBox& fault);
ObjectFields fields_of(CrossingPerson& fault);
ObjectFields fields_of(Lifted& fault);
ObjectFields fields_of(LaserOff& fault);
ObjectFields fields_of(LightChange& fault);

/// All kinds of fault with their keys: visit(key, fault).
template <class Visit>
void for_each_fault(const Visit& visit) {
  visit("camera", CameraFault{});
  visit("slip", SlipBurst{});
  visit("steering", SteeringBias{});
  visit("box", BlockingBox{});
  visit("person", CrossingPerson{});
  visit("lift", Lifted{});
  visit("laser_off", LaserOff{});
  visit("light", LightChange{});
}

}  // namespace aisle
