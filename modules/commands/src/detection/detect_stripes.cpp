#include <fmt/format.h>

#include "aisle/report/detection_overlay.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"
#include "detection/picture_detector.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

class StripeDetector final : public PictureDetector {
 public:
  void describe(FieldList& fields) override { fields.group("stripes", params_); }

  Detection detect(const Image& picture, bool is_drawn) override {
    const auto stripes = find_laser_stripes(picture, params_);
    Detection detection;
    Json& listed = detection.figures["stripes"] = Json::array();
    std::size_t columns = 0;
    for (const LaserStripe& stripe : stripes) {
      listed.push_back(
          {{"polyline", polyline_json(stripe.points_px)}, {"corners", polyline_json(stripe.corners_px)}});
      columns += stripe.points_px.size();
    }
    detection.summary = fmt::format("{} stripes over {} columns", stripes.size(), columns);
    if (is_drawn) detection.overlay_png = stripes_overlay_png(picture, stripes);
    return detection;
  }

 private:
  StripeParams params_;
};

}  // namespace

std::unique_ptr<PictureDetector> make_stripe_detector() {
  return std::make_unique<StripeDetector>();
}

}  // namespace aisle
