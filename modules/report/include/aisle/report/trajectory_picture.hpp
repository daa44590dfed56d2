#pragma once

#include <span>
#include <string>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A path over the true one, in one frame [m], with a line from each pose to its true one. Both lists have
/// the same length. Drawn to scale, y up, the longer side 1600 px.
struct TrajectoryPicture {
  std::span<const Pose2> path;
  std::span<const Pose2> truth;
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const TrajectoryPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const TrajectoryPicture& picture);

}  // namespace aisle
