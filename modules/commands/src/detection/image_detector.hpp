#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/result.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// What was found in one image.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON throws only where its own invariant is broken
struct Detection {
  nlohmann::ordered_json figures;       ///< the feature's own keys
  std::string summary;                  ///< for people, less than a line
  std::string overlay_png;              ///< empty if not asked for
  std::optional<std::string> mask_png;  ///< only of features that are areas
  std::vector<VerticalLine> verticals;  ///< only if these are the feature
};

/// A feature's detector and its parameters.
class ImageDetector {
 public:
  virtual ~ImageDetector() = default;

  virtual void describe(FieldList& fields) = 0;
  virtual Detection detect(const Image& image, bool is_drawn) = 0;
  /// Called if all images so far were of one drive, in order: adds what they show together to their figures.
  /// @return the same for people, in lines
  virtual std::string look_back(nlohmann::ordered_json& /*images*/) { return {}; }
};

/// @param camera  if given, its distortion is removed before lines are fitted
std::unique_ptr<ImageDetector> make_verticals_detector(const std::optional<CameraModel>& camera);
std::unique_ptr<ImageDetector> make_base_lines_detector(const std::optional<CameraModel>& camera);
std::unique_ptr<ImageDetector> make_stripe_detector();
std::unique_ptr<ImageDetector> make_region_detector();

/// An image from a taught place.
struct TaughtImage {
  std::string name;
  Image image;
};

/// @param paths  images, and directories of them, in order
Result<std::vector<TaughtImage>> read_taught_images(const std::vector<std::filesystem::path>& paths);
/// @param taught  in order along a path, at least one
std::unique_ptr<ImageDetector> make_places_detector(std::vector<TaughtImage> taught);

/// [u, v] in pixels, to a thousandth.
nlohmann::ordered_json pixel_json(const Vec2& pixel);
nlohmann::ordered_json polyline_json(const std::vector<Vec2>& pixels);

}  // namespace aisle
