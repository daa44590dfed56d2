#include "vehicle/vehicle_eyes.hpp"

#include <algorithm>
#include <utility>

namespace aisle {
namespace {

CameraSensorParams sensor_params(const SimulatedParts& simulated, const std::string& camera) {
  const auto found = simulated.cameras.find(camera);
  return found == simulated.cameras.end() ? CameraSensorParams{} : found->second;
}

}  // namespace

VehicleEyes::VehicleEyes(const World& world, const VehicleModel& model, Random& seeds)
    : world_(world), laser_markers_(model.description.laser_markers) {
  for (const CameraDescription& camera : model.description.cameras) {
    eyes_.push_back(
        {.camera = camera, .sensor = {camera, sensor_params(model.simulated, camera.name), seeds.bits()}});
  }
}

/// Image k is due at k periods, the first after one.
bool VehicleEyes::Eye::is_due(double now_s) const {
  constexpr double kSlack_s = 1e-6;
  return now_s + kSlack_s >= static_cast<double>(taken + 1) * camera.period_s;
}

void VehicleEyes::Eye::take(double now_s, CameraMoment moment, const RenderedWorld& world,
                            const CameraTrouble& trouble) {
  moment.image = taken++;
  if (trouble.dark) {
    moment.light = 0;
    moment.laser_on = false;
  }
  feed.take({.camera = camera.name,
             .stamp_s = now_s,
             .pixels = std::make_shared<const Image>(sensor.take(world, moment))},
            trouble);
}

void VehicleEyes::look(double now_s, const CameraMoment& moment, std::span<const MovingBody> bodies,
                       const ScenarioPlay& play) {
  const auto is_due = [&](const Eye& eye) { return eye.is_due(now_s); };
  if (std::none_of(eyes_.begin(), eyes_.end(), is_due)) return;
  world_.place(bodies);
  CameraMoment lit = moment;
  lit.light = play.light().light;
  lit.lamps_on = play.light().lamps_on;
  lit.laser_on = laser_markers_ && play.laser_is_on();
  if (laser_markers_) lit.laser_height_m = laser_markers_->height_m;
  for (Eye& eye : eyes_) {
    if (eye.is_due(now_s)) eye.take(now_s, lit, world_, play.trouble_of(eye.camera.name));
  }
}

std::vector<CameraImage> VehicleEyes::deliver(double now_s) {
  std::vector<CameraImage> images;
  for (Eye& eye : eyes_) {
    if (auto image = eye.feed.deliver(now_s)) images.push_back(std::move(*image));
  }
  return images;
}

}  // namespace aisle
