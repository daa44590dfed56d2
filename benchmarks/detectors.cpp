/// Near-vertical lines and base lines in images 640 pixels wide, compared with OpenCV's line detectors on one
/// core: the line segment detector, and Canny edges with the probabilistic Hough transform. The image is a
/// drawn corridor with noise; with AISLE_DATA, also the images of real corridors there. The counter
/// `times_segment_detector` is the ratio of frame rates to OpenCV's detector on the same images.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "aisle/core/random.hpp"
#include "aisle/formats/images/image_file.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "drawn_corridor.hpp"

namespace aisle {
namespace {

constexpr int kWidth_px = 640;

Image drawn_image() {
  DrawnCorridor corridor;
  corridor.shine = 0.25;
  Image image = corridor.image();
  Random random(1);
  for (auto& byte : image.bytes) {
    byte = static_cast<std::uint8_t>(std::clamp(std::lround(byte + random.normal(3)), 0L, 255L));
  }
  return image;
}

cv::Mat view_of(const Image& image) {
  return {image.height_px, image.width_px, CV_8U, const_cast<std::uint8_t*>(image.bytes.data())};
}

Image as_wide_as_the_drawn(const Image& image) {
  Image out(kWidth_px, kWidth_px * image.height_px / image.width_px);
  cv::Mat resized = view_of(out);
  cv::resize(view_of(image), resized, resized.size(), 0, 0, cv::INTER_AREA);
  return out;
}

const std::vector<Image>& recorded_images(bool real) {
  static const std::vector<Image> drawn{drawn_image()};
  static const std::vector<Image> recorded = [] {
    std::vector<Image> images;
    const char* data = std::getenv("AISLE_DATA");
    if (data == nullptr) return images;
    for (const char* set :
         {"rtabmap_corridor_2laps", "gaoyuan_corridor", "hedau_layout/corridor", "roadtracer_hallway"}) {
      const auto directory = std::filesystem::path(data) / "images" / set;
      if (!std::filesystem::exists(directory)) continue;
      for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".jpg") continue;
        if (const auto image = read_image(entry.path()))
          images.push_back(as_wide_as_the_drawn(to_grey(*image)));
      }
    }
    return images;
  }();
  return real ? recorded : drawn;
}

double seconds_by_segment_detector(bool real) {
  static std::array<double, 2> seconds{};
  double& known = seconds[real ? 1 : 0];
  if (known > 0) return known;
  const auto detector = cv::createLineSegmentDetector();
  std::vector<cv::Vec4f> segments;
  const auto start = std::clock();
  int frames = 0;
  for (int round = 0; round < (real ? 1 : 10); ++round) {
    for (const Image& image : recorded_images(real)) {
      detector->detect(view_of(image), segments);
      ++frames;
    }
  }
  const double passed_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return known = passed_s / frames;
}

/// Runs `detect(index)` over the images; counts frames and the ratio to OpenCV's segment detector.
template <class Detect>
void over_images(benchmark::State& state, const Detect& detect) {
  cv::setNumThreads(1);
  const bool real = state.range(0) != 0;
  const auto& images = recorded_images(real);
  const double baseline_s = seconds_by_segment_detector(real);
  std::size_t i = 0;
  const auto start = std::clock();
  for (auto _ : state) {
    detect(i);
    i = (i + 1) % images.size();
  }
  const double passed_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  state.counters["times_segment_detector"] = baseline_s * static_cast<double>(state.iterations()) / passed_s;
  state.SetLabel(real ? "recorded images" : "drawn corridor");
}

void vertical_lines(benchmark::State& state) {
  VerticalLineDetector detector;
  const auto& images = recorded_images(state.range(0) != 0);
  over_images(state, [&](std::size_t i) { benchmark::DoNotOptimize(detector.detect(images[i])); });
}

void base_lines(benchmark::State& state) {
  VerticalLineDetector vertical_detector;
  BaseLineDetector detector;
  const auto& images = recorded_images(state.range(0) != 0);
  std::vector<std::vector<VerticalLine>> verticals;
  for (const Image& image : images) verticals.push_back(vertical_detector.detect(image));
  over_images(state,
              [&](std::size_t i) { benchmark::DoNotOptimize(detector.detect(images[i], verticals[i])); });
}

void segment_detector(benchmark::State& state) {
  const auto detector = cv::createLineSegmentDetector();
  std::vector<cv::Vec4f> segments;
  const auto& images = recorded_images(state.range(0) != 0);
  over_images(state, [&](std::size_t i) { detector->detect(view_of(images[i]), segments); });
}

void canny_and_hough(benchmark::State& state) {
  cv::Mat edges;
  std::vector<cv::Vec4i> segments;
  const auto& images = recorded_images(state.range(0) != 0);
  over_images(state, [&](std::size_t i) {
    cv::Canny(view_of(images[i]), edges, 50, 150);
    cv::HoughLinesP(edges, segments, 1, CV_PI / 180, 50, 40, 5);
  });
}

void with_images(benchmark::internal::Benchmark* measured) {
  measured->Unit(benchmark::kMillisecond)->Arg(0);
  if (!recorded_images(true).empty()) measured->Arg(1);
}

BENCHMARK(vertical_lines)->Apply(with_images);
BENCHMARK(base_lines)->Apply(with_images);
BENCHMARK(segment_detector)->Apply(with_images);
BENCHMARK(canny_and_hough)->Apply(with_images);

}  // namespace
}  // namespace aisle
