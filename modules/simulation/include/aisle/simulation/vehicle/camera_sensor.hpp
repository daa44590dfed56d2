#pragma once
/// What a camera on a vehicle sees of a world, and what the sensor makes of it.

#include <cstdint>
#include <memory>
#include <span>

#include "aisle/core/angle.hpp"
#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

struct LensTable;
struct CollectedLight;

/// Something upright that comes and goes: a person, a box that blocks the path.
struct MovingBody {
  enum class Kind { kPerson, kBox };
  Kind kind = Kind::kBox;
  Pose2 T_world_body;
  Vec2 size = Vec2::Ones();  ///< along its x and y
  double height_m = 1.7;
  double brightness = 0.4;
};

/// A world ready to be seen: its panels, and the light on them. Built once, shared by all cameras.
class RenderedWorld {
 public:
  explicit RenderedWorld(const World& world);
  ~RenderedWorld();
  RenderedWorld(RenderedWorld&&) noexcept;
  RenderedWorld& operator=(RenderedWorld&&) noexcept;

  /// Replaces the moving bodies.
  void place(std::span<const MovingBody> bodies);

  struct Scene;  ///< of the renderer alone

 private:
  friend class CameraSensor;
  std::unique_ptr<Scene> scene_;
};

/// A camera's faults, and how it is exposed. The defaults are an ordinary industrial camera.
struct CameraSensorParams {
  double exposure = 1;       ///< 1: white paper under the world's lamps is just not overexposed
  double vignetting = 0.2;   ///< share of light lost in the corners
  double noise_sigma = 1.5;  ///< of a pixel in mid grey [grey levels]; grows with brightness as light does
  double exposure_time_s = 0.01;           ///< what moves meanwhile is blurred
  double shake_pitch_rad = 0.1 * kDegree;  ///< standard deviation at 1 m/s
  double shake_roll_rad = 0.1 * kDegree;   ///< standard deviation at 1 m/s
  double gamma = 2;        ///< of the response curve; 1: grey levels are proportional to light
  int rays_per_pixel = 4;  ///< where surfaces meet; elsewhere patterns are filtered and one is enough

  void describe(FieldList& fields);
};

/// Where the vehicle is when an image is taken, and how it moves meanwhile.
struct CameraMoment {
  Pose2 T_world_vehicle;  ///< in the middle of the exposure
  double speed_mps = 0;   ///< of base_link, forwards
  double turn_rate_rad_s = 0;
  bool lamps_on = true;
  double light = 1;       ///< all light times this: day, dusk
  bool laser_on = false;  ///< the vehicle's line lasers
  double laser_height_m = 0.3;
  double laser_ahead_m = 0.6;  ///< the projector, ahead of base_link; it shines to all sides ahead of it
  std::uint64_t image = 0;  ///< its number: with the seed it determines noise and shake, whatever the order
};

/// Takes images. Rays go through the lens model, so known points land where CameraModel::project says.
/// The same arguments give the same bytes, whatever the number of threads and what was taken before.
class CameraSensor {
 public:
  CameraSensor(const CameraDescription& camera, const CameraSensorParams& params, std::uint64_t seed);
  ~CameraSensor();
  CameraSensor(CameraSensor&&) noexcept;
  CameraSensor& operator=(CameraSensor&&) noexcept;

  /// Grey, camera.width_px x camera.height_px.
  Image take(const RenderedWorld& world, const CameraMoment& moment);

 private:
  CameraDescription camera_;
  CameraSensorParams params_;
  std::uint64_t seed_;
  std::unique_ptr<const LensTable> lens_;
  std::unique_ptr<CollectedLight> light_;  ///< of the image in the making; kept, as new memory takes long
};

}  // namespace aisle
