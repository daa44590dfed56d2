#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// The content of a map picture. Everything is in `map` [m]; walls, path and loop closures may be empty.
/// Drawn to scale, y up, the longer side 1600 px.
struct MapPicture {
  const WallMap& walls;
  std::span<const Pose2> path = {};
  std::span<const std::pair<std::size_t, std::size_t>> loop_closures = {};  ///< indices into `path`
  std::string title = {};
  std::string caption = {};  ///< one line below the title
  bool has_grid = false;     ///< faint lines at round distances
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const MapPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const MapPicture& picture);

}  // namespace aisle
