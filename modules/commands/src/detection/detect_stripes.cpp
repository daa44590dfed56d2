#include <fmt/format.h>

#include "aisle/report/detection_overlay.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"
#include "detection/image_detector.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

class StripeDetector final : public ImageDetector {
 public:
  void describe(FieldList& fields) override { fields.group("stripes", params_); }

  Detection detect(const Image& image, bool is_drawn) override {
    const auto stripes = find_laser_stripes(image, params_);
    Detection detection;
    Json& listed = detection.figures["stripes"] = Json::array();
    std::size_t columns = 0;
    for (const LaserStripe& stripe : stripes) {
      listed.push_back(
          {{"polyline", polyline_json(stripe.points_px)}, {"corners", polyline_json(stripe.corners_px)}});
      columns += stripe.points_px.size();
    }
    detection.summary = fmt::format("{} stripes over {} columns", stripes.size(), columns);
    if (is_drawn) detection.overlay_png = stripes_overlay_png(image, stripes);
    return detection;
  }

 private:
  StripeParams params_;
};

}  // namespace

std::unique_ptr<ImageDetector> make_stripe_detector() {
  return std::make_unique<StripeDetector>();
}

}  // namespace aisle
