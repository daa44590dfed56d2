#pragma once

#include <span>
#include <string>

#include "aisle/exploration/exploration_record.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// What was explored and how: free floor white on grey, obstacles dark, walls, the driven path, a ring at
/// each path that was not taken yet, a disc at those given up or left undone. Drawn to scale, y up, the
/// longer side 1600 px.
struct ExplorationPicture {
  const FloorGrid& floor;
  const WallMap& walls;
  const ExplorationRecord& record;
  std::span<const Pose2> T_map_vehicle;  ///< the driven path
  std::string title = {};
  std::string caption = {};
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const ExplorationPicture& picture);

/// The picture as a PNG file. Same picture, same bytes.
std::string png(const ExplorationPicture& picture);

}  // namespace aisle
