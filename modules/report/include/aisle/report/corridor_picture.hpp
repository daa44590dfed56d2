#pragma once

#include <span>
#include <string>

#include "aisle/maps/building.hpp"

namespace aisle {

/// An explored building: its floor as seen, its walls, the graph of corridors with the names of its nodes,
/// places, and a driven path. Everything is in `map`; every part may be empty. Drawn to scale, y up, the
/// longer side 1600 px.
struct CorridorPicture {
  const Building& building;
  std::span<const Pose2> path = {};
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const CorridorPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const CorridorPicture& picture);

}  // namespace aisle
