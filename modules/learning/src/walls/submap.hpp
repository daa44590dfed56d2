#pragma once

#include <span>
#include <vector>

#include "aisle/learning/walls/scan_tracker.hpp"
#include "walls/scan_segments.hpp"

namespace aisle {

/// The walls of a few metres of path as one rigid piece, anchored at its middle keyframe.
struct Submap {
  std::size_t first_keyframe = 0;
  std::size_t last_keyframe = 0;
  std::size_t anchor_keyframe = 0;
  Pose2 T_track_anchor;
  double path_m = 0;                ///< at the anchor
  std::vector<WallEstimate> walls;  ///< in `track`; only those surer than a single glimpse
};

Submap build_submap(std::size_t first_keyframe, std::size_t last_keyframe,
                    std::span<const Keyframe> keyframes, const ScanSegments& segments,
                    const WallUpdateParams& update);

/// Appends the submap's walls in `map`, given the anchor's pose. Orthogonal walls stay on the axes through
/// small turns.
void place_walls(const Submap& submap, const Pose2& T_map_anchor, std::vector<WallEstimate>& walls);

}  // namespace aisle
