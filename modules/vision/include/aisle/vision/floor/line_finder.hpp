#pragma once

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

struct LineFinderParams {
  VerticalLineParams verticals;
  BaseLineParams base_lines;

  void describe(FieldList& fields);
};

/// The lines of one image, in pixels of the image as given.
struct FoundLines {
  std::vector<VerticalLine> verticals;  ///< from left to right, floor points decided
  BaseLines base_lines;
};

/// Finds the vertical lines and the wall-floor edges of an image together: each detector needs the other's
/// result.
class LineFinder {
 public:
  /// @param camera  if given, lines are fitted where its distortion is undone; they are reported as seen
  explicit LineFinder(const LineFinderParams& params = {},
                      const std::optional<CameraModel>& camera = std::nullopt);

  FoundLines find(const Image& image);

 private:
  BaseLineParams base_line_params_;
  VerticalLineDetector verticals_;
  BaseLineDetector base_lines_;
};

}  // namespace aisle
