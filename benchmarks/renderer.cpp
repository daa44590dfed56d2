/// 640 x 480 images of an office corridor with lamps, soft shadows and a laser stripe, compared with the ray
/// tracer's primary rays alone (one per pixel, no shading) in the same scene and run. The argument is the
/// number of threads; `of_raw` is the ratio of the rate of finished pixels to the raw rate.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "office_corridor.hpp"
#include "rendering/exposure.hpp"

namespace aisle {
namespace {

constexpr int kDoorsPerSide = 9;
constexpr int kWholeFloorDoorsPerSide = 60;

CameraDescription camera() {
  CameraDescription camera;
  camera.intrinsics = {460, 460, 319.5, 239.5, -0.18, 0.03, 0, 0, 0};
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1.0}, .tilt_rad = 14 * kDegree};
  return camera;
}

CameraMoment moment(std::uint64_t image, double turn_rate_rad_s) {
  CameraMoment moment;
  moment.T_world_vehicle = {1 + 0.1 * static_cast<double>(image % 200), 0, 0};
  moment.turn_rate_rad_s = turn_rate_rad_s;
  moment.laser_on = true;
  moment.image = image;
  return moment;
}

const World& corridor(int doors_per_side) {
  static const World short_one = office_corridor(kDoorsPerSide);
  static const World long_one = office_corridor(kWholeFloorDoorsPerSide);
  return doors_per_side == kDoorsPerSide ? short_one : long_one;
}

const RenderedWorld& rendered_corridor(int doors_per_side) {
  static const RenderedWorld short_one(corridor(kDoorsPerSide));
  static const RenderedWorld long_one(corridor(kWholeFloorDoorsPerSide));
  return doors_per_side == kDoorsPerSide ? short_one : long_one;
}

double pixels_per_image() {
  return static_cast<double>(camera().width_px) * camera().height_px;
}

/// Primary rays per second of the last raw run, by number of threads.
double& raw_rays_per_s(std::int64_t threads) {
  static double rates[3] = {};
  return rates[threads];
}

std::vector<RayPacket> primary_rays(const LensTable& lens, const Viewpoint& view) {
  std::vector<RayPacket> packets;
  for (const LensTable::Block& block : lens.blocks) packets.push_back(block_rays(block, view, {}, {}));
  return packets;
}

void RawPrimaryRays(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const World& world = corridor(kDoorsPerSide);
  const RenderedWorld::Scene scene(world);
  const LensTable lens(camera(), 0);
  const auto packets = primary_rays(lens, viewpoints(camera(), {}, moment(0, 0), 1, scene.frame).front());
  const auto begin = std::chrono::steady_clock::now();
  for ([[maybe_unused]] auto _ : state) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, packets.size(), 64), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        Hits hits;
        scene.what_stands().first_hits(packets[i], hits);
        benchmark::DoNotOptimize(hits);
      }
    });
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const double rays = static_cast<double>(state.iterations()) * pixels_per_image();
  raw_rays_per_s(state.range(0)) = rays / taken.count();
  state.counters["rays/s"] = rays / taken.count();
}
BENCHMARK(RawPrimaryRays)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void take_images(benchmark::State& state, int doors_per_side, double turn_rate_rad_s) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const RenderedWorld& world = rendered_corridor(doors_per_side);
  CameraSensor sensor(camera(), {}, 1);
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t image = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(sensor.take(world, moment(image++, turn_rate_rad_s)));
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const double frames_per_s = static_cast<double>(state.iterations()) / taken.count();
  state.counters["frames/s"] = frames_per_s;
  state.counters["of_raw"] = frames_per_s * pixels_per_image() / raw_rays_per_s(state.range(0));
}

void Images(benchmark::State& state) {
  take_images(state, kDoorsPerSide, 0);
}
BENCHMARK(Images)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void ImagesOfAWholeFloor(benchmark::State& state) {
  take_images(state, kWholeFloorDoorsPerSide, 0);
}
BENCHMARK(ImagesOfAWholeFloor)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void ImagesWithMotionBlur(benchmark::State& state) {
  take_images(state, kDoorsPerSide, 1);
}
BENCHMARK(ImagesWithMotionBlur)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void BuildingTheScene(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(RenderedWorld(corridor(kDoorsPerSide)));
}
BENCHMARK(BuildingTheScene)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aisle
