#pragma once

#include <string>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Points seen together: one view of a board, or the marks of one image.
struct ResidualGroup {
  std::string name;
  double rms_px = 0;
  std::vector<Vec2> points_px;
  std::vector<Vec2> residuals_px;  ///< seen minus expected, one per point; not drawn if not finite
};

/// The residuals of a calibration: where in the camera image the points were seen, by how much each missed
/// its expected place (arrows, magnified by a factor that the picture states), and each group's RMS as a bar.
struct ResidualPicture {
  int width_px = 0;  ///< of the camera's images; > 0
  int height_px = 0;
  std::vector<ResidualGroup> groups;
  std::string title;
  std::string caption;  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const ResidualPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const ResidualPicture& picture);

}  // namespace aisle
