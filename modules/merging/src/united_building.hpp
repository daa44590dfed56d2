#pragma once

#include <span>
#include <string>
#include <vector>

#include "aisle/merging/building_merging.hpp"

namespace aisle {

/// All parts as one building, in the frame of the poses.
/// @param T_map_part  one per part
/// @param notes       receives what was renamed or left out
Building united_building(std::span<const MapPart> parts, std::span<const Pose2> T_map_part,
                         std::vector<std::string>& notes);

}  // namespace aisle
