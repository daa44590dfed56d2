#include "aisle/vision/places/place_recogniser.hpp"

#include <algorithm>
#include <cstddef>

namespace aisle {
namespace {

constexpr double kLightTone = 128;  ///< to which all images are scaled before their lines are compared

/// The 90 % quantile of a view's tones: of the walls, whatever stands before them.
double light_tone(Image view) {
  const auto tenth = static_cast<std::ptrdiff_t>(view.bytes.size() / 10);
  std::nth_element(view.bytes.begin(), view.bytes.end() - tenth, view.bytes.end());
  return std::max<double>(1, *(view.bytes.end() - tenth));
}

}  // namespace

void PlaceParams::describe(FieldList& fields) {
  fields.group("columns", columns);
  fields.group("verticals", verticals);
  fields.group("lines", lines);
  fields.real("unlike_max", unlike_max, {0, 1}, "how unlike the most alike taught image may be; 0: the same");
  fields.count("rival_apart", rival_apart, {0, 1000},
               "taught images up to this many apart may show one place");
  fields.real("rival_factor", rival_factor, {1, 100}, "by which all others must be more unlike");
  fields.count("ahead_max", ahead_max, {1, 1000},
               "greatest advance, in taught images, from one of a drive's images to the next");
}

PlaceRecogniser::PlaceRecogniser(const PlaceParams& params) : params_(params), verticals_(params.verticals) {}

void PlaceRecogniser::teach(const Image& image) {
  order_.push_back(static_cast<double>(taught_.size()));
  taught_.push_back(look_at(image));
}

std::optional<ViewRecognition> PlaceRecogniser::recognise(const Image& image) {
  const Look seen = look_at(image);
  unlike_.resize(taught_.size());
  std::transform(taught_.begin(), taught_.end(), unlike_.begin(),
                 [&](const Look& taught) { return unlikeness(taught, seen); });
  return recognise_view(unlike_, order_, params_.rival_apart);
}

PlaceRecogniser::Look PlaceRecogniser::look_at(const Image& image) {
  const Image grey = to_grey(image), view = column_view(grey);
  Look look{ViewCurves(params_.columns, view), line_looks(grey, verticals_.detect(grey))};
  const double exposure = kLightTone / light_tone(view);
  for (LineLook& line : look.lines) {
    line.tone_left *= exposure;
    line.tone_right *= exposure;
  }
  return look;
}

double PlaceRecogniser::unlikeness(const Look& a, const Look& b) const {
  const double curves_alike = std::clamp(1 - a.curves.unlikeness(b.curves), 0.0, 1.0);
  return 1 - curves_alike * std::clamp(lines_likeness(a.lines, b.lines, params_.lines), 0.0, 1.0);
}

}  // namespace aisle
