#include "aisle/vision/places/view_recognition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aisle {

std::optional<ViewRecognition> recognise_view(std::span<const double> unlike, std::span<const double> along,
                                              double apart) {
  if (unlike.empty()) return std::nullopt;
  const auto least =
      static_cast<std::size_t>(std::min_element(unlike.begin(), unlike.end()) - unlike.begin());
  ViewRecognition recognition{
      .view = least, .unlike = unlike[least], .rival_unlike = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < unlike.size(); ++i) {
    if (std::abs(along[i] - along[least]) <= apart) continue;
    recognition.rival_unlike = std::min(recognition.rival_unlike, unlike[i]);
  }
  return recognition;
}

std::vector<bool> confirmed_in_succession(std::span<const std::size_t> views, std::size_t ahead_max) {
  std::vector<bool> confirmed(views.size());
  const auto goes_on = [&](std::size_t i) {
    return views[i + 1] >= views[i] && views[i + 1] - views[i] <= ahead_max;
  };
  for (std::size_t i = 0; i + 2 < views.size(); ++i) {
    if (goes_on(i) && goes_on(i + 1) && views[i + 2] > views[i])
      confirmed[i] = confirmed[i + 1] = confirmed[i + 2] = true;
  }
  return confirmed;
}

}  // namespace aisle
