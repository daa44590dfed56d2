#include "aisle/simulation/camera_sensor.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "office_corridor.hpp"

using namespace aisle;

namespace {

CameraDescription ordinary_camera() {
  CameraDescription camera;
  camera.width_px = 322;  // no multiple of a packet's side
  camera.height_px = 239;
  camera.intrinsics = {240, 241, 160.2, 118.7, -0.15, 0.02, 0.001, -0.0005, 0};
  camera.mount = {.p_vehicle_camera = {0.5, 0.05, 1.0},
                  .tilt_rad = 10 * kDegree,
                  .pan_rad = 3 * kDegree,
                  .roll_rad = 2 * kDegree};
  return camera;
}

CameraMoment driving() {
  CameraMoment moment;
  moment.T_world_vehicle = {1, 0.1, 0.05};
  moment.speed_mps = 0.5;
  moment.turn_rate_rad_s = 0.5;
  moment.laser_on = true;
  moment.picture = 7;
  return moment;
}

TEST(CameraSensor, TakesTheSamePictureWhateverTheNumberOfThreads) {
  const auto picture = [](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    RenderedWorld world(office_corridor(2));
    const std::vector<MovingBody> bodies = {{MovingBody::Kind::kPerson, {4, -0.3, 3}, {0.3, 0.5}}};
    world.place(bodies);
    return CameraSensor(ordinary_camera(), {}, 1).take(world, driving());
  };
  EXPECT_EQ(picture(1), picture(2));
}

}  // namespace
