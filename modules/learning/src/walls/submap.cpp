#include "walls/submap.hpp"

#include <cmath>

namespace aisle {
namespace {

constexpr double kGlimpse_m = 1.5;             // a wall seen once counts only if it is longer than this
constexpr double kAxisTurn_rad = 2 * kDegree;  // a submap turned farther than this leaves the axes
constexpr double kAxisTolerance_rad = 3 * kDegree;

}  // namespace

Submap build_submap(std::size_t first_keyframe, std::size_t last_keyframe,
                    std::span<const Keyframe> keyframes, const ScanSegments& segments,
                    const WallUpdateParams& update) {
  Submap submap;
  submap.first_keyframe = first_keyframe;
  submap.last_keyframe = last_keyframe;
  submap.anchor_keyframe = (first_keyframe + last_keyframe) / 2;
  submap.T_track_anchor = keyframes[submap.anchor_keyframe].T_track_sensor;
  submap.path_m = keyframes[submap.anchor_keyframe].path_m;
  std::vector<int> candidates;
  for (std::size_t k = first_keyframe; k <= last_keyframe; ++k) {
    for (const SensedSegment& s : segments.of_scan(keyframes[k].scan)) {
      absorb(PlacedSegment(s, keyframes[k].T_track_sensor), keyframes[k].path_m, update, submap.walls,
             candidates);
    }
  }
  std::erase_if(submap.walls,
                [](const WallEstimate& w) { return w.sightings < 2 && w.length_m() <= kGlimpse_m; });
  return submap;
}

void place_walls(const Submap& submap, const Pose2& T_map_anchor, std::vector<WallEstimate>& walls) {
  const double turn = wrap_angle(T_map_anchor.theta - submap.T_track_anchor.theta);
  const bool leaves_axes = std::abs(turn) > kAxisTurn_rad;
  const Pose2 T_map_track = T_map_anchor * submap.T_track_anchor.inverse();
  for (WallEstimate wall : submap.walls) {
    wall.anchor = T_map_track * wall.anchor;
    if (wall.is_oblique() || leaves_axes) {
      const bool was_orthogonal = !wall.is_oblique();
      wall.set_heading(wrap_angle(wall.heading_rad + turn));
      wall.facing = was_orthogonal ? facing_of(wall.heading_rad, kAxisTolerance_rad) : Facing::kOblique;
    }
    walls.push_back(wall);
  }
}

}  // namespace aisle
