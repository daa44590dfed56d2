#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "aisle/vision/check/view_check.hpp"

namespace aisle {

/// What else a check knows of its images.
struct CheckScope {
  std::size_t found = 0;     ///< images in all that the user named
  std::size_t checked = 0;   ///< of these, looked at
  std::size_t left_out = 0;  ///< cannot be read, or have another size than the others
  bool is_lens_known = false;
  std::optional<double> tilt_rad;  ///< of the camera by the corridor's end, > 0: down; needs the lens
};

nlohmann::ordered_json view_check_json(const ViewCheck& check, const CheckScope& scope);
nlohmann::ordered_json evidence_json(const ImageEvidence& evidence, const GoodViews& views);

/// The same for people: what was measured, what are hints, and what cannot be said.
std::string view_check_text(const ViewCheck& check, const CheckScope& scope);

}  // namespace aisle
