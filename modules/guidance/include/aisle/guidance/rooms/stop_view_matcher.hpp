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

/// Tells by what is seen how far off the odometry is about the path that is left to a taught place (L96
/// section 3.5). As published a learned view matches when the eight places where columns are brightest and
/// darkest are within delta; beyond the paper, the curves themselves are compared, a match counts only if no
/// view from elsewhere is nearly as much alike, and only if several images in succession agree.
class StopViewMatcher {
 public:
  StopViewMatcher(const StopViewParams& params, const std::vector<StopView>& views);

  /// @param left_m  path to the place, by odometry
  void take(const Image& image, double left_m);

  /// More path to go than the odometry says; 0 while nothing has matched.
  double shift_m() const { return shift_m_.value_or(0); }
  bool has_matched() const { return shift_m_.has_value(); }

 private:
  std::optional<double> match(const Image& image);
  std::optional<double> match_curves(const Image& image);
  std::optional<double> match_extremes(const Image& image);

  StopViewParams params_;
  std::vector<double> left_m_;            ///< of the taught views
  std::vector<BrightnessView> extremes_;  ///< of the same
  std::vector<ViewCurves> curves_;        ///< of the same; empty if compared by their extremes
  std::vector<double> unlike_;            ///< of the same, in the image before the vehicle
  std::deque<double> shifts_m_;           ///< of the latest images that matched, one after another
  std::optional<double> shift_m_;
};

}  // namespace aisle
