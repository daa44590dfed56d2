/// The cost of recording a session: processor time per second of driving, one camera at 10 Hz with 640 x 480
/// images, compared with encoding the same images and nothing else.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/sessions/session_record.hpp"

namespace aisle {
namespace {

constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;
constexpr double kPeriod_s = 0.1;
constexpr int kImages = 20;  // distinct images, used in turn

/// A simple corridor: floor tiles and walls running to a vanishing point, shading, pixel noise.
Image corridor(int channels, Random& random) {
  Image image(kWidth_px, kHeight_px, channels);
  const double vanishing_u = 320 + random.uniform(-60, 60);
  for (int v = 0; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) {
      const double across = (u - vanishing_u) / (std::abs(v - 200) + 1.0);
      const double depth = 4000 / (std::abs(v - 200) + 20.0);
      const bool is_floor = v > 200 && std::abs(across) < 1.2;
      const bool is_dark_tile =
          (static_cast<int>(std::floor(across * 4)) + static_cast<int>(depth / 10)) % 2 == 0;
      const double shade = is_floor ? (is_dark_tile ? 90 : 120) : 170 - 0.5 * depth;
      for (int c = 0; c < channels; ++c) {
        const double value = shade - 10 * c + random.normal(2.5);
        image.row(v)[u * channels + c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  }
  return image;
}

std::vector<std::shared_ptr<const Image>> images(int channels) {
  Random random(1);
  std::vector<std::shared_ptr<const Image>> all;
  for (int i = 0; i < kImages; ++i) all.push_back(std::make_shared<Image>(corridor(channels, random)));
  return all;
}

VehicleDescription vehicle() {
  VehicleDescription description;
  description.cameras.resize(1);
  return description;
}

double process_cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Records while the benchmark runs, one cycle per iteration.
void record(benchmark::State& state, const ImageCoding& coding, int channels) {
  const auto all = images(channels);
  const auto directory = std::filesystem::temp_directory_path() / "aisle-benchmark-session";
  auto session = SessionRecord::create(directory, true, vehicle(), {.navigator = "none"}, coding);
  if (!session) return state.SkipWithError(to_string(session.problems()).c_str());
  Observation observation;
  std::size_t cycles = 0;
  const double start_cpu_s = process_cpu_s();
  for (auto _ : state) {
    observation.stamp_s = kPeriod_s * static_cast<double>(++cycles);
    observation.images = {{"front", observation.stamp_s, all[cycles % all.size()]}};
    benchmark::DoNotOptimize(session->keep(observation));
    if (!session->keep(Decision{.state = "on"}).empty()) return state.SkipWithError("not kept");
  }
  if (!session->close().empty()) return state.SkipWithError("not closed");
  const double duration_s = kPeriod_s * static_cast<double>(cycles);
  state.counters["percent_of_a_core"] = 100 * (process_cpu_s() - start_cpu_s) / duration_s;
  std::uintmax_t bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(directory)) bytes += file.file_size();
  state.counters["MB_in_10_min"] = static_cast<double>(bytes) * 1e-6 / duration_s * 600;
  std::filesystem::remove_all(directory);
}

/// The baseline: the images to JPEG and back. Any recording of compressed images must do this, if the
/// navigator is to see what is stored.
void BM_EncodeAndDecodeOnly(benchmark::State& state, int channels) {
  const auto all = images(channels);
  std::size_t cycles = 0;
  const double start_cpu_s = process_cpu_s();
  for (auto _ : state) {
    benchmark::DoNotOptimize(parse_image(jpeg_bytes(*all[cycles++ % all.size()], 90), "picture"));
  }
  state.counters["percent_of_a_core"] =
      100 * (process_cpu_s() - start_cpu_s) / (kPeriod_s * static_cast<double>(cycles));
}

void BM_RecordJpeg(benchmark::State& state, int channels) {
  record(state, {}, channels);
}
void BM_RecordRaw(benchmark::State& state, int channels) {
  record(state, {ImageCoding::Kind::kRaw}, channels);
}
void BM_RecordPng(benchmark::State& state, int channels) {
  record(state, {ImageCoding::Kind::kPng}, channels);
}

// 6000 cycles are ten minutes of driving.
BENCHMARK_CAPTURE(BM_EncodeAndDecodeOnly, grey, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RecordJpeg, grey, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_EncodeAndDecodeOnly, colour, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RecordJpeg, colour, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RecordRaw, grey, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RecordPng, grey, 1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aisle
