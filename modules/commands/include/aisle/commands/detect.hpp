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
  std::optional<std::filesystem::path> camera;   ///< file with the camera's calibration; optional
  std::optional<std::filesystem::path> overlay;  ///< directory for drawings and masks; none: figures only
  bool follow = false;  ///< verticals, places: the images are of one drive, in order. Lines keep their
                        ///< numbers, consecutive places along the path confirm each other
  std::vector<std::filesystem::path> taught;  ///< places: images (or directories) of the places, in order
  bool force = false;
  ParameterSources parameters;
};

/// `aisle detect FEATURE IMAGE...`: runs a feature's detector on each image; figures are in pixels of the
/// image as given. If one image cannot be read or has not the camera's size, that is a problem and nothing is
/// written.
Result<Outcome> run_detect(const DetectOptions& options, Console& console);

/// Every parameter of a feature's detector with its default.
Outcome detect_parameters(Feature feature);

}  // namespace aisle
