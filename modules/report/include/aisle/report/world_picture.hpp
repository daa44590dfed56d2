#pragma once

#include <string>

#include "aisle/simulation/world.hpp"

namespace aisle {

/// The plan of a world: walls, door leaves with their opening arcs, furniture, posters, lamps, parking
/// frames, walking people's paths, and tour, start and places. Drawn to scale, y up, the longer side 1600 px.
struct WorldPicture {
  const World& world;
  std::string title = {};
  std::string caption = {};  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const WorldPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const WorldPicture& picture);

}  // namespace aisle
