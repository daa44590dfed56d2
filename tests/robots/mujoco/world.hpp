#pragma once
/// What a world file of docs/formats/world.md says of the things that a vehicle can touch or see.

#include <string>
#include <vector>

#include "pose.hpp"

namespace robots {

/// An upright box or pillar, in the frame `world`: x right, y up, z from the floor.
struct Solid {
  enum class Shape { kBox, kPillar };
  Shape shape = Shape::kBox;
  Pose2 T_world_centre;
  double length_m = 1;  ///< along its own x; of a pillar: the diameter
  double width_m = 1;   ///< along its own y
  double bottom_m = 0;
  double top_m = 1;
  double brightness = 0.5;  ///< 0 black to 1 white
  /// What is not lies flat on something that is: cameras alone see it.
  bool is_obstacle = true;
};

struct World {
  std::vector<Solid> solids;
  Pose2 T_world_start;
  std::vector<Pose2> tour;  ///< where a person leads a vehicle; headings are 0
  double tile_m = 0.3;
  double floor_brightness = 0.5;
  std::vector<std::string> left_out;  ///< keys of the file that are none of the above, as "people"
};

/// Throws std::runtime_error, with the place in the file, if it is no world.
World read_world(const std::string& path);

}  // namespace robots
