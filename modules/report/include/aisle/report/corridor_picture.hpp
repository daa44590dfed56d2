#pragma once

#include <span>
#include <string>

#include "aisle/maps/building.hpp"

namespace aisle {

/// A building that was explored: its floor as it was seen, walls, the graph of corridors with the names of
/// its nodes, places, and a path that was driven. Everything is in `map`; every part may be empty. Drawn to
/// scale, y up, the longer side 1600 px.
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
