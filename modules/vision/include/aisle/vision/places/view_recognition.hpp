#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace aisle {

/// The taught view that a view is recognised as.
struct ViewRecognition {
  std::size_t view = 0;     ///< the most alike one
  double unlike = 0;        ///< how unlike it is, 0 or more
  double rival_unlike = 0;  ///< of the most alike view from elsewhere; infinity: there is none

  /// Beyond L96: being alike is not enough where a view from elsewhere is nearly as alike.
  bool is_sure(double unlike_max, double rival_factor) const {
    return unlike <= unlike_max && rival_unlike >= rival_factor * unlike;
  }
};

/// @param unlike   how unlike each taught view is
/// @param along    where each was taken, along the route
/// @param apart    views farther apart than this, in the unit of `along`, are of different places
/// @return nullopt if there is no view
std::optional<ViewRecognition> recognise_view(std::span<const double> unlike, std::span<const double> along,
                                              double apart);

/// Which images of one drive are confirmed by their neighbours: the most alike views of three images in
/// succession advance along the route by at most `ahead_max` views from each to the next.
/// @param views  the most alike view of each image in order, numbered along the route
std::vector<bool> confirmed_in_succession(std::span<const std::size_t> views, std::size_t ahead_max);

}  // namespace aisle
