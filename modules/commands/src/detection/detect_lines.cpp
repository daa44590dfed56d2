#include <fmt/format.h>

#include <algorithm>

#include "aisle/report/detection_overlay.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"
#include "detection/image_detector.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// Vertical lines and wall-floor edges of one image; each detector needs the other's result.
class LineFinder {
 public:
  explicit LineFinder(const std::optional<CameraModel>& camera) : camera_(camera) {}

  void describe(FieldList& fields) {
    fields.group("verticals", verticals_params_);
    fields.group("baselines", base_lines_params_);
  }

  struct Lines {
    std::vector<VerticalLine> verticals;
    BaseLines base_lines;
  };

  Lines find(const Image& image) {
    if (!verticals_) {
      verticals_.emplace(verticals_params_, camera_);
      base_lines_.emplace(base_lines_params_, camera_);
    }
    const Image grey = to_grey(image);
    Lines lines;
    lines.verticals = verticals_->detect(grey);
    lines.base_lines = base_lines_->detect(grey, lines.verticals);
    stand_on_floor(grey, lines.base_lines, base_lines_params_, lines.verticals);
    return lines;
  }

 private:
  std::optional<CameraModel> camera_;
  VerticalLineParams verticals_params_;
  BaseLineParams base_lines_params_;
  std::optional<VerticalLineDetector> verticals_;  // made once the parameters are known
  std::optional<BaseLineDetector> base_lines_;
};

class VerticalsDetector final : public ImageDetector {
 public:
  explicit VerticalsDetector(const std::optional<CameraModel>& camera) : finder_(camera) {}

  void describe(FieldList& fields) override { finder_.describe(fields); }

  Detection detect(const Image& image, bool is_drawn) override {
    Detection detection;
    const auto& verticals = detection.verticals = finder_.find(image).verticals;
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

 private:
  LineFinder finder_;
};

Json line_json(const std::optional<BaseLine>& line) {
  return line ? polyline_json(*line) : Json(nullptr);
}

class BaseLinesDetector final : public ImageDetector {
 public:
  explicit BaseLinesDetector(const std::optional<CameraModel>& camera) : finder_(camera) {}

  void describe(FieldList& fields) override { finder_.describe(fields); }

  Detection detect(const Image& image, bool is_drawn) override {
    const BaseLines lines = finder_.find(image).base_lines;
    Detection detection;
    detection.figures = {{"right_baseline", line_json(lines.right)},
                         {"left_baseline", line_json(lines.left)}};
    detection.summary = fmt::format("right wall-floor edge {}, left wall-floor edge {}",
                                    lines.right ? "found" : "not found", lines.left ? "found" : "not found");
    if (is_drawn) detection.overlay_png = base_lines_overlay_png(image, lines);
    return detection;
  }

 private:
  LineFinder finder_;
};

}  // namespace

std::unique_ptr<ImageDetector> make_verticals_detector(const std::optional<CameraModel>& camera) {
  return std::make_unique<VerticalsDetector>(camera);
}

std::unique_ptr<ImageDetector> make_base_lines_detector(const std::optional<CameraModel>& camera) {
  return std::make_unique<BaseLinesDetector>(camera);
}

}  // namespace aisle
