#include "aisle/simulation/vehicle/camera_sensor.hpp"

#include "rendering/exposure.hpp"

namespace aisle {
namespace {

LightLevels light_levels(const RenderedWorld::Scene& scene, const CameraMoment& moment) {
  LightLevels levels;
  levels.from_everywhere = static_cast<float>(moment.light * scene.ambient_light);
  levels.from_lamps = static_cast<float>(moment.lamps_on ? moment.light * (1 - scene.ambient_light) : 0);
  levels.glow = static_cast<float>(moment.lamps_on ? moment.light : 0);
  return levels;
}

LaserPlane laser_plane(const CameraMoment& moment, const SceneFrame& frame) {
  constexpr float kStrength = 5;
  if (!moment.laser_on) return {};
  const Vec2 projector = moment.T_world_vehicle * Vec2(moment.laser_ahead_m, 0);
  const Eigen::Vector3f p = frame({projector.x(), projector.y(), moment.laser_height_m}).cast<float>();
  const Eigen::Vector2f ahead = unit(moment.T_world_vehicle.theta).cast<float>();
  return {{p.x(), p.y(), p.z()}, {ahead.x(), ahead.y()}, kStrength};
}

}  // namespace

CameraSensor::CameraSensor(const CameraDescription& camera, const CameraSensorParams& params,
                           std::uint64_t seed)
    : camera_(camera),
      params_(params),
      seed_(seed),
      lens_(std::make_unique<LensTable>(camera, params.vignetting)),
      light_(std::make_unique<CollectedLight>()) {}

CameraSensor::~CameraSensor() = default;
CameraSensor::CameraSensor(CameraSensor&&) noexcept = default;
CameraSensor& CameraSensor::operator=(CameraSensor&&) noexcept = default;

Image CameraSensor::take(const RenderedWorld& world, const CameraMoment& moment) {
  const RenderedWorld::Scene& scene = *world.scene_;
  const std::vector<Viewpoint> views = viewpoints(camera_, params_, moment, seed_, scene.frame);
  const int count = static_cast<int>(views.size());
  Exposure exposure(scene, *lens_, light_levels(scene, moment), laser_plane(moment, scene.frame), *light_);
  for (const Viewpoint& view : views) {
    exposure.add(view, (params_.rays_per_pixel + count - 1) / count, 1 / static_cast<float>(count));
  }
  const SensorResponse response(params_.noise_sigma, params_.gamma, seed_, moment.image);
  return exposure.develop(response, params_.exposure);
}

}  // namespace aisle
