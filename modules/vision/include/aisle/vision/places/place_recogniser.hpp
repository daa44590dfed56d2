#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vision/lines/line_follower.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"
#include "aisle/vision/places/column_view.hpp"
#include "aisle/vision/places/view_recognition.hpp"

namespace aisle {

struct PlaceParams {
  ColumnViewParams columns{.lateral_max = 0.2, .approach_max = 2.7};
  VerticalLineParams verticals;
  LineFollowerParams lines;
  double unlike_max = 0.7;
  int rival_apart = 1;
  double rival_factor = 1.15;
  int ahead_max = 3;

  void describe(FieldList& fields);
};

/// Recognises places that were taught by one image each, also from some metres away, without odometry. Two
/// cues must agree, as each alone is ambiguous: the curves of columns' brightness repeat wherever lamps hang
/// in a row, the vertical lines wherever doors do.
class PlaceRecogniser {
 public:
  explicit PlaceRecogniser(const PlaceParams& params);

  /// Adds the next place along the route.
  void teach(const Image& image);

  /// The taught place that the image is most like; rivals are places that are not its neighbours along the
  /// route. Some 20 ms for each taught place.
  /// @return nullopt if no place was taught
  std::optional<ViewRecognition> recognise(const Image& image);
  bool is_sure(const ViewRecognition& recognition) const {
    return recognition.is_sure(params_.unlike_max, params_.rival_factor);
  }
  /// Given the most alike places of a drive's images, in order: which of them their neighbours confirm.
  std::vector<bool> confirmed(std::span<const std::size_t> places) const {
    return confirmed_in_succession(places, static_cast<std::size_t>(params_.ahead_max));
  }

 private:
  struct Look {
    ViewCurves curves;
    std::vector<LineLook> lines;
  };

  Look look_at(const Image& image);
  double unlikeness(const Look& a, const Look& b) const;

  PlaceParams params_;
  VerticalLineDetector verticals_;
  std::vector<Look> taught_;
  std::vector<double> order_;   // of the taught places
  std::vector<double> unlike_;  // of the taught places, to the latest image
};

}  // namespace aisle
