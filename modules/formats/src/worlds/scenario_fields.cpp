#include "worlds/scenario_fields.hpp"

#include <array>

namespace aisle {
namespace {

constexpr Range kTime_s = {0, 1e6};

constexpr std::array<std::string_view, 4> kCameraFaults = {"frozen", "dark", "dropped", "late"};
constexpr std::array<std::string_view, 2> kSwitch = {"off", "on"};

}  // namespace

WorldFields fields_of(EventTimes& times) {
  return {{.key = "from_s", .target = &times.from_s, .range = kTime_s},
          {.key = "for_s", .target = &times.for_s, .range = {0.01, 1e6}},
          {.key = "near", .target = PointTarget{{&times.near.x(), &times.near.y()}}, .range = kCoordinate_m},
          {.key = "radius_m", .target = &times.radius_m, .range = {0.01, 1000}}};
}

WorldFields fields_of(CameraFault& fault) {
  CameraFault::Kind& kind = fault.kind;
  return {{.key = "fault",
           .target = WordTarget{kCameraFaults, [&kind] { return static_cast<std::size_t>(kind); },
                                [&kind](std::size_t i) { kind = static_cast<CameraFault::Kind>(i); }},
           .range = {},
           .is_needed = true},
          {.key = "name", .target = &fault.camera, .range = {}},
          {.key = "delay_s", .target = &fault.delay_s, .range = {0.01, 60}}};
}

WorldFields fields_of(SlipBurst& fault) {
  return {{.key = "spin", .target = &fault.spin, .range = {-1, 100}}};
}

WorldFields fields_of(SteeringBias& fault) {
  return {{.key = "bias_deg",
           .target = &fault.bias_rad,
           .range = {-45, 45},
           .inner_unit = kDegree,
           .is_needed = true}};
}

WorldFields fields_of(BlockingBox& fault) {
  Pose2& pose = fault.T_world_box;
  return {
      {.key = "centre", .target = PointTarget{{&pose.x, &pose.y}}, .range = kCoordinate_m, .is_needed = true},
      {.key = "size", .target = PointTarget{{&fault.size.x(), &fault.size.y()}}, .range = {0.01, 1000}},
      {.key = "heading_deg", .target = &pose.theta, .range = {-360, 360}, .inner_unit = kDegree},
      {.key = "height_m", .target = &fault.height_m, .range = {0.01, 100}}};
}

WorldFields fields_of(CrossingPerson& fault) {
  return fields_of(fault.person);
}

WorldFields fields_of(Lifted& fault) {
  return fields_of(fault.T_world_vehicle);
}

WorldFields fields_of(LaserOff&) {
  return {};
}

WorldFields fields_of(LightChange& fault) {
  bool& lamps_on = fault.lamps_on;
  return {{.key = "light", .target = &fault.light, .range = {0, 10}},
          {.key = "lamps",
           .target = WordTarget{kSwitch, [&lamps_on] { return static_cast<std::size_t>(lamps_on); },
                                [&lamps_on](std::size_t i) { lamps_on = i == 1; }},
           .range = {}}};
}

}  // namespace aisle
