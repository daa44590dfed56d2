/// Laser stripes and free-space segmentation of a 640 x 480 image, compared with OpenCV's means for the same
/// purpose: for stripes blurring, a vertical derivative and the strongest row of each column; for the region
/// the watershed from a floor marker and a wall marker. The counter `share_of_baseline` is the ratio of the
/// times in the same run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "aisle/core/random.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"

namespace aisle {
namespace {

constexpr int kWidth = 640, kHeight = 480;

/// A tiled corridor floor between walls with doors, a red stripe on the walls, and sensor noise.
Image corridor() {
  Image image(kWidth, kHeight, 3);
  Random random(1);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double lateral = std::abs(u - 319.5), depth = std::max(1.0, lateral / 320);
      const bool is_floor = v > 240 + 0.7 * lateral && v > 270;
      const bool is_door = !is_floor && static_cast<int>(lateral / 60) % 2 == 1 && v > 160;
      const bool is_joint = is_floor && (v - 240) % 40 < 2;
      double grey = is_floor ? 120 + (v - 240) / 8.0 : is_door ? 90 : 180 / depth;
      if (is_joint) grey -= 15;
      const double off = (v - (262 + 0.2 * lateral)) / 1.2;
      const double lit = is_floor ? 0 : 90 * std::exp(-off * off / 2);
      for (int c = 0; c < 3; ++c) {
        const double value = grey + (c == 0 ? lit : 0.1 * lit) + 3 * random.normal();
        image.row(v)[3 * u + c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  }
  return image;
}

cv::Mat to_mat(Image& image) {
  return {image.height_px, image.width_px, CV_8UC3, image.bytes.data()};
}

std::vector<int> strongest_rows(const cv::Mat& scene) {
  cv::Mat grey, smooth, slope;
  cv::cvtColor(scene, grey, cv::COLOR_RGB2GRAY);
  cv::GaussianBlur(grey, smooth, {5, 5}, 1);
  cv::Sobel(smooth, slope, CV_16S, 0, 1);
  std::vector<int> rows(kWidth, 0);
  std::vector<short> best(kWidth, 0);
  for (int v = 0; v < kHeight; ++v) {
    const short* row = slope.ptr<short>(v);
    for (std::size_t u = 0; u < kWidth; ++u) {
      if (row[u] <= best[u]) continue;
      best[u] = row[u];
      rows[u] = v;
    }
  }
  return rows;
}

cv::Mat floor_by_watershed(const cv::Mat& scene) {
  cv::Mat markers(kHeight, kWidth, CV_32S, cv::Scalar(0));
  markers(cv::Rect(280, 450, 80, 30)) = 1;
  markers(cv::Rect(0, 0, kWidth, 140)) = 2;
  cv::watershed(scene, markers);
  return markers;
}

template <class Call>
double seconds_per_call(Call call) {
  constexpr int kCalls = 20;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kCalls; ++i) benchmark::DoNotOptimize(call());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kCalls;
}

template <class Ours, class Baseline>
void compare(benchmark::State& state, Ours ours, Baseline baseline) {
  cv::setNumThreads(1);
  for (auto _ : state) benchmark::DoNotOptimize(ours());
  state.counters["share_of_baseline"] = seconds_per_call(ours) / seconds_per_call(baseline);
}

void BM_LaserStripes(benchmark::State& state) {
  Image scene = corridor();
  compare(
      state, [&] { return find_laser_stripes(scene); }, [&] { return strongest_rows(to_mat(scene)); });
}

void BM_RouteRegion(benchmark::State& state) {
  Image scene = corridor();
  RouteRegionFinder finder;
  Image mask;
  const auto find = [&] {
    finder.find(scene, mask);
    return mask.bytes.data();
  };
  compare(state, find, [&] { return floor_by_watershed(to_mat(scene)); });
}

void BM_LaserStripesInGrey(benchmark::State& state) {
  Image scene = corridor();
  const Image grey = to_grey(scene);
  compare(
      state, [&] { return find_laser_stripes(grey); }, [&] { return strongest_rows(to_mat(scene)); });
}

BENCHMARK(BM_LaserStripes)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LaserStripesInGrey)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RouteRegion)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aisle
