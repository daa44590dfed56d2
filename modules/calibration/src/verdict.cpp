#include "aisle/calibration/verdict.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

std::string_view to_string(CalibrationQuality quality) {
  switch (quality) {
    case CalibrationQuality::kGood:
      return "good";
    case CalibrationQuality::kUsable:
      return "usable";
    case CalibrationQuality::kPoor:
      return "poor";
  }
  return "";
}

void CalibrationVerdict::limit(CalibrationQuality at_best, std::string reason) {
  quality = std::max(quality, at_best);
  reasons.push_back(std::move(reason));
}

}  // namespace aisle
