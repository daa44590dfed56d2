#include <fmt/format.h>

#include <algorithm>

#include "aisle/report/detection_overlay.hpp"
#include "aisle/vision/floor/line_finder.hpp"
#include "detection/image_detector.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// The parameters are known only when the first image comes.
class LineDetector : public ImageDetector {
 public:
  explicit LineDetector(const std::optional<CameraModel>& camera) : camera_(camera) {}

  void describe(FieldList& fields) override { params_.describe(fields); }

 protected:
  FoundLines find(const Image& image) {
    if (!finder_) finder_.emplace(params_, camera_);
    return finder_->find(image);
  }

 private:
  std::optional<CameraModel> camera_;
  LineFinderParams params_;
  std::optional<LineFinder> finder_;
};

class VerticalsDetector final : public LineDetector {
 public:
  using LineDetector::LineDetector;

  Detection detect(const Image& image, bool is_drawn) override {
    Detection detection;
    const auto& verticals = detection.verticals = find(image).verticals;
    Json& listed = detection.figures["verticals"] = Json::array();
    for (const VerticalLine& line : verticals) {
      listed.push_back({{"top", pixel_json(line.top_px)},
                        {"bottom", pixel_json(line.bottom_px)},
                        {"foot", line.has_floor_point}});
    }
    const auto floor_points = std::count_if(verticals.begin(), verticals.end(),
                                            [](const VerticalLine& line) { return line.has_floor_point; });
    detection.summary =
        fmt::format("{} vertical lines, {} with a floor point", verticals.size(), floor_points);
    if (is_drawn) detection.overlay_png = verticals_overlay_png(image, verticals);
    return detection;
  }
};

Json line_json(const std::optional<BaseLine>& line) {
  return line ? polyline_json(*line) : Json(nullptr);
}

class BaseLinesDetector final : public LineDetector {
 public:
  using LineDetector::LineDetector;

  Detection detect(const Image& image, bool is_drawn) override {
    const BaseLines lines = find(image).base_lines;
    Detection detection;
    detection.figures = {{"right_baseline", line_json(lines.right)},
                         {"left_baseline", line_json(lines.left)}};
    detection.summary = fmt::format("right wall-floor edge {}, left wall-floor edge {}",
                                    lines.right ? "found" : "not found", lines.left ? "found" : "not found");
    if (is_drawn) detection.overlay_png = base_lines_overlay_png(image, lines);
    return detection;
  }
};

}  // namespace

std::unique_ptr<ImageDetector> make_verticals_detector(const std::optional<CameraModel>& camera) {
  return std::make_unique<VerticalsDetector>(camera);
}

std::unique_ptr<ImageDetector> make_base_lines_detector(const std::optional<CameraModel>& camera) {
  return std::make_unique<BaseLinesDetector>(camera);
}

}  // namespace aisle
