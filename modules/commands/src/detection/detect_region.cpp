#include <fmt/format.h>

#include <cmath>

#include "aisle/formats/images/image_file.hpp"
#include "aisle/report/detection_overlay.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "detection/image_detector.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// The scan lines of L96 Algorithm 4, as shares of the image's height.
struct ScanLines {
  double far_row_share = 0.75;
  double near_row_share = 0.9;

  void describe(FieldList& fields) {
    fields.real("far_row_share", far_row_share, {0, 1},
                "row of the upper scan line, as a share of the image's height");
    fields.real("near_row_share", near_row_share, {0, 1},
                "row of the lower scan line, as a share of the image's height");
  }
};

int row_at(double share, const Image& image) {
  return static_cast<int>(std::lround(share * (image.height_px - 1)));
}

Json middle_json(const std::optional<RouteMiddle>& middle) {
  if (!middle) return nullptr;
  return {{"far", pixel_json(middle->far_px)},
          {"near", pixel_json(middle->near_px)},
          {"mean", pixel_json(middle->mean_px)}};
}

class RegionDetector final : public ImageDetector {
 public:
  void describe(FieldList& fields) override {
    fields.group("region", params_);
    fields.group("middle", lines_);
  }

  Detection detect(const Image& image, bool is_drawn) override {
    const RouteRegion region = find_route_region(image, params_);
    const auto middle = find_route_middle(region.mask, row_at(lines_.far_row_share, image),
                                          row_at(lines_.near_row_share, image));
    Detection detection;
    detection.figures = {{"region_share", region.share}, {"middle", middle_json(middle)}};
    detection.summary = fmt::format("route on {:.1f} % of the image", 100 * region.share);
    if (is_drawn) detection.overlay_png = region_overlay_png(image, region, middle);
    detection.mask_png = png_bytes(region.mask);
    return detection;
  }

 private:
  RegionParams params_;
  ScanLines lines_;
};

}  // namespace

std::unique_ptr<ImageDetector> make_region_detector() {
  return std::make_unique<RegionDetector>();
}

}  // namespace aisle
