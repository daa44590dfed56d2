#pragma once

#include <span>
#include <string>

#include "aisle/maps/building.hpp"

namespace aisle {

/// What is known of a building: its floor as seen, its walls, the graph of corridors with the names of its
/// nodes, routes, landmarks (a disc each, fainter with less weight), places, lines that a person drew, and a
/// driven path. Everything is in `map`; every part may be empty. Drawn to scale, y up, the longer side 1600
/// px.
struct BuildingPicture {
  const Building& building;
  std::span<const Pose2> path = {};
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const BuildingPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const BuildingPicture& picture);

}  // namespace aisle
