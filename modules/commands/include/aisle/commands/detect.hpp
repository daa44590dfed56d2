#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

/// What to look for in images.
enum class Feature { kVerticals, kBaseLines, kStripes, kRegion, kPlaces };

struct DetectOptions {
  Feature feature = Feature::kRegion;
  std::vector<std::string> files;
  std::optional<std::filesystem::path> camera;   ///< its calibration; none: found without
  std::optional<std::filesystem::path> overlay;  ///< directory for drawings and masks; none: figures only
  bool follow = false;  ///< verticals, places: the images are one drive's, in order; lines are numbered
                        ///< through them, places that go on along the path confirm each other
  std::vector<std::filesystem::path> taught;  ///< places: their images, or directories of them, in order
  bool force = false;
  ParameterSources parameters;
};

/// `aisle detect FEATURE IMAGE...`: what a feature's detector finds in each image, in pixels of the image
/// as given. One image that cannot be read, or that is not of the camera's size, is a problem, and then
/// nothing is written.
Result<Outcome> run_detect(const DetectOptions& options, Console& console);

/// Every parameter of a feature's detector with its default.
Outcome detect_parameters(Feature feature);

}  // namespace aisle
