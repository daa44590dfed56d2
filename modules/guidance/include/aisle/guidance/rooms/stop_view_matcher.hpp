#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/vision/places/column_view.hpp"

namespace aisle {

struct StopViewParams {
  bool by_extremes = false;
  double delta = 0.04;
  ColumnViewParams columns;
  double unlike_max = 0.1;
  double within_m = 1.5;
  double rival_m = 0.15;
  double rival_factor = 1.3;
  int confirmations = 3;
  double agree_m = 0.12;
  double gain = 0.3;

  void describe(FieldList& fields);
};

/// Corrects by images the path left to a taught place (L96 section 3.5). As published, a learned view matches
/// if the eight places where its columns are brightest and darkest agree within delta. Beyond the paper, the
/// brightness curves themselves are compared; a match counts only if no view from elsewhere is nearly as
/// similar, and if several images in a row agree.
class StopViewMatcher {
 public:
  StopViewMatcher(const StopViewParams& params, const std::vector<StopView>& views);

  /// @param left_m  path left to the place, by odometry
  void take(const Image& image, double left_m);

  /// Path left beyond what the odometry says; 0 while nothing has matched.
  double shift_m() const { return shift_m_.value_or(0); }
  bool has_matched() const { return shift_m_.has_value(); }

 private:
  std::optional<double> match(const Image& image);
  std::optional<double> match_curves(const Image& image);
  std::optional<double> match_extremes(const Image& image);

  StopViewParams params_;
  std::vector<double> left_m_;            ///< one per taught view
  std::vector<BrightnessView> extremes_;  ///< one per taught view
  std::vector<ViewCurves> curves_;        ///< one per taught view; empty if compared by their extremes
  std::vector<double> unlike_;            ///< one per taught view, compared with the present image
  std::deque<double> shifts_m_;           ///< of the last images in a row that matched
  std::optional<double> shift_m_;
};

}  // namespace aisle
