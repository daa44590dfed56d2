#include "aisle/simulation/scenario_play.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

ScenarioPlay::ScenarioPlay(Scenario scenario) {
  for (ScenarioEvent& event : scenario.events) events_.push_back({.event = std::move(event)});
}

void ScenarioPlay::advance(double now_s, const Vec2& p_world_vehicle) {
  for (auto& [event, begun_s, is_on] : events_) {
    const bool is_near = !event.near || (*event.near - p_world_vehicle).norm() <= event.radius_m;
    if (!begun_s && now_s >= event.from_s && is_near) begun_s = now_s;
    is_on = begun_s && now_s < *begun_s + event.duration_s;
  }
}

template <class Kind, class Use>
void ScenarioPlay::for_each_on(Use use) const {
  for (const PlayedEvent& played : events_) {
    const Kind* const fault = std::get_if<Kind>(&played.event.fault);
    if (played.is_on && fault != nullptr) use(*fault);
  }
}

double ScenarioPlay::spin() const {
  double spin = 0;
  for_each_on<SlipBurst>([&](const SlipBurst& burst) { spin += burst.spin; });
  return spin;
}

double ScenarioPlay::steering_bias_rad() const {
  double bias_rad = 0;
  for_each_on<SteeringBias>([&](const SteeringBias& step) { bias_rad += step.bias_rad; });
  return bias_rad;
}

bool ScenarioPlay::laser_is_on() const {
  bool is_on = true;
  for_each_on<LaserOff>([&](const LaserOff&) { is_on = false; });
  return is_on;
}

LightChange ScenarioPlay::light() const {
  LightChange light{.light = 1};
  for_each_on<LightChange>([&](const LightChange& change) {
    light.light *= change.light;
    light.lamps_on = light.lamps_on && change.lamps_on;
  });
  return light;
}

CameraTrouble ScenarioPlay::trouble_of(std::string_view camera) const {
  CameraTrouble trouble;
  for_each_on<CameraFault>([&](const CameraFault& fault) {
    if (!fault.camera.empty() && fault.camera != camera) return;
    switch (fault.kind) {
      case CameraFault::Kind::kFrozen:
        trouble.frozen = true;
        return;
      case CameraFault::Kind::kDark:
        trouble.dark = true;
        return;
      case CameraFault::Kind::kDropped:
        trouble.dropped = true;
        return;
      case CameraFault::Kind::kLate:
        trouble.delay_s = std::max(trouble.delay_s, fault.delay_s);
        return;
    }
  });
  return trouble;
}

}  // namespace aisle
