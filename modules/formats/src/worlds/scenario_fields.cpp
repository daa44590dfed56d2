#include "worlds/scenario_fields.hpp"

#include <array>

namespace aisle {
namespace {

constexpr Range kTime_s = {0, 1e6};

constexpr std::array<std::string_view, 4> kCameraFaults = {"frozen", "dark", "dropped", "late"};
constexpr std::array<std::string_view, 2> kSwitch = {"off", "on"};

}  // namespace

ObjectFields fields_of(EventTimes& times) {
  return {field::number("from_s", times.from_s, kTime_s), field::number("for_s", times.for_s, {0.01, 1e6}),
          field::point("near", times.near, kCoordinate_m),
          field::number("radius_m", times.radius_m, {0.01, 1000})};
}

ObjectFields fields_of(CameraFault& fault) {
  return {needed(field::word("fault", fault.kind, kCameraFaults)), field::text("name", fault.camera),
          field::number("delay_s", fault.delay_s, {0.01, 60})};
}

ObjectFields fields_of(SlipBurst& fault) {
  return {field::number("spin", fault.spin, {-1, 100})};
}

ObjectFields fields_of(SteeringBias& fault) {
  return {needed(field::angle("bias_deg", fault.bias_rad, {-45, 45}))};
}

ObjectFields fields_of(BlockingBox& fault) {
  Pose2& pose = fault.T_world_box;
  return {needed(field::point("centre", pose.x, pose.y, kCoordinate_m)),
          field::point("size", fault.size, {0.01, 1000}), field::angle("heading_deg", pose.theta),
          field::number("height_m", fault.height_m, {0.01, 100})};
}

ObjectFields fields_of(CrossingPerson& fault) {
  return fields_of(fault.person);
}

ObjectFields fields_of(Lifted& fault) {
  return fields_of(fault.T_world_vehicle);
}

ObjectFields fields_of(LaserOff&) {
  return {};
}

ObjectFields fields_of(LightChange& fault) {
  return {field::number("light", fault.light, {0, 10}), field::word("lamps", fault.lamps_on, kSwitch)};
}

}  // namespace aisle
