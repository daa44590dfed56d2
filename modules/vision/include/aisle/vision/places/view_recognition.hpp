#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace aisle {

/// Which of several taught views one is taken for.
struct ViewRecognition {
  std::size_t view = 0;  ///< the one that is most alike
  double unlike = 0;     ///< how unlike it is, 0 or more
  double rival_unlike =
      0;  ///< the same of the one that is most alike of those from elsewhere; infinity: none

  /// Beyond L96: looking alike is not enough where elsewhere looks nearly so, too.
  bool is_sure(double unlike_max, double rival_factor) const {
    return unlike <= unlike_max && rival_unlike >= rival_factor * unlike;
  }
};

/// @param unlike   how unlike each taught view is
/// @param along    where each was taken, along the path
/// @param apart    views that are farther apart are of different places
/// @return nullopt if there is none
std::optional<ViewRecognition> recognise_view(std::span<const double> unlike, std::span<const double> along,
                                              double apart);

/// Which images of one drive are confirmed by those beside them: of three in succession the most alike
/// views go on along the path, at most `ahead_max` from each to the next.
/// @param views  of the images in order, by their places along the path
std::vector<bool> confirmed_in_succession(std::span<const std::size_t> views, std::size_t ahead_max);

}  // namespace aisle
