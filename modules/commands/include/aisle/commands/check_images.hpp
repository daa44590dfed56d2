#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct CheckImagesOptions {
  /// Images, folders of images, and what open_image_sequence() reads; at least one.
  std::vector<std::string> recordings;
  std::optional<std::filesystem::path> calibration;  ///< none: a recording's own, if it has one
  std::string topic;                                 ///< topic of a bag's images; empty: the only one
  int images_max = 200;                              ///< of more images, so many are looked at; >= 1
  std::optional<std::filesystem::path> out;          ///< directory for the overlays
  bool force = false;
  ParameterSources parameters;
};

/// `aisle detect --check`: says whether the camera of these images sees what each method drives by, as far as
/// images tell that nobody labelled, and what would help. An image that was named and cannot be read is a
/// problem; in a folder or a recording it is left out and counted.
Result<Outcome> run_check_images(const CheckImagesOptions& options, Console& console);

/// Every parameter of the check with its default.
Outcome check_images_parameters();

}  // namespace aisle
