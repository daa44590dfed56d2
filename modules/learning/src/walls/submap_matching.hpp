#pragma once

#include <span>
#include <vector>

#include "aisle/matching/wall_estimate.hpp"
#include "walls/submap.hpp"

namespace aisle {

/// How one piece of map fits another at its best displacement.
struct SubmapFit {
  Vec2 displacement_m = Vec2::Zero();  ///< moves the new walls onto the old ones
  double score = 0;  ///< share of the new walls' length that lies on old walls of the same facing, 0 .. 1
  double rival_score = 0;  ///< score of the best clearly different displacement, high in look-alike places
  double matched_m[2] = {0, 0};  ///< matched wall length that fixes x and y
};

/// The box in which old walls are known well enough that a missing one counts.
struct KnownArea {
  Vec2 low = Vec2::Constant(1e9);
  Vec2 high = Vec2::Constant(-1e9);

  void include(const Vec2& p, double margin_m) {
    low = low.cwiseMin(p - Vec2::Constant(margin_m));
    high = high.cwiseMax(p + Vec2::Constant(margin_m));
  }
  bool contains(const Vec2& p) const {
    return p.x() >= low.x() && p.y() >= low.y() && p.x() <= high.x() && p.y() <= high.y();
  }
};

/// Walls sorted so that those near a given wall are found quickly.
class WallPattern {
 public:
  explicit WallPattern(std::vector<WallEstimate> walls);

  const std::vector<WallEstimate>& walls() const { return walls_; }

  /// The wall that this one, displaced, fits best (same facing, within `gate_m` across), and the length in
  /// common.
  struct Hit {
    const WallEstimate* wall = nullptr;
    double common_m = 0;
  };
  Hit hit(const WallEstimate& wall, const Vec2& displacement_m, double gate_m) const;

 private:
  std::vector<WallEstimate> walls_;  ///< sorted by facing, then by offset
  std::vector<double> coordinates_;
  std::size_t first_of_facing_[6] = {};
};

/// Searches for the displacement of up to `reach_m` that moves the new walls onto the old ones: signature
/// peaks on two axes (C99 Algorithm 2), with every pair of them verified by the overlap of walls.
SubmapFit fit_submap(std::span<const WallEstimate> fresh, const WallPattern& old, const KnownArea& known,
                     double reach_m);

/// Turns that align many new walls with the headings of old ones, and no turn: without axes to hold the
/// heading, it may have drifted by degrees on a long path.
std::vector<double> likely_turns(std::span<const WallEstimate> fresh, std::span<const WallEstimate> old);

/// The submap's pose, refined wall by wall from a good guess.
struct RefinedFit {
  Pose2 T_map_anchor;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta) from the matched walls, in `map`
};

RefinedFit refine_fit(const Submap& submap, const Pose2& T_map_anchor, const WallPattern& old,
                      const KnownArea& known);

}  // namespace aisle
