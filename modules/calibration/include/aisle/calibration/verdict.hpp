#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aisle {

enum class CalibrationQuality { kGood, kUsable, kPoor };

std::string_view to_string(CalibrationQuality quality);

/// What a calibration is worth, for people.
struct CalibrationVerdict {
  CalibrationQuality quality = CalibrationQuality::kGood;
  std::vector<std::string> reasons;  ///< what lowers the quality, each with what would help

  /// The quality is `at_best` from now on, because of `reason`.
  void limit(CalibrationQuality at_best, std::string reason);
};

}  // namespace aisle
