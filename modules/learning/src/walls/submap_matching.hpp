#pragma once

#include <span>
#include <vector>

#include "aisle/matching/wall_estimate.hpp"
#include "walls/submap.hpp"

namespace aisle {

/// How a piece of map fits onto another at its best displacement.
struct SubmapFit {
  Vec2 displacement_m = Vec2::Zero();  ///< carries the new walls onto the old ones
  double score = 0;  ///< share of the new walls' length that lies on old walls of the same facing, 0 .. 1
  double rival_score = 0;        ///< of the best clearly different displacement: look-alike places have one
  double matched_m[2] = {0, 0};  ///< matched wall length that fixes x and y
};

/// The box in which the old walls are known well enough to be missed.
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

/// Walls ordered so that those near a given wall are found quickly.
class WallPattern {
 public:
  explicit WallPattern(std::vector<WallEstimate> walls);

  const std::vector<WallEstimate>& walls() const { return walls_; }

  /// The wall that this one, displaced, lies on best (same facing, within `gate_m` across), and the length in
  /// common.
  struct Hit {
    const WallEstimate* wall = nullptr;
    double common_m = 0;
  };
  Hit hit(const WallEstimate& wall, const Vec2& displacement_m, double gate_m) const;

 private:
  std::vector<WallEstimate> walls_;  ///< sorted by facing, then by coordinate across
  std::vector<double> coordinates_;
  std::size_t first_of_facing_[6] = {};
};

/// Looks for the displacement of up to `reach_m` that carries the new walls onto the old ones: signature
/// peaks on two axes (C99 Algorithm 2), every pair of them checked by how much wall lies on wall.
SubmapFit fit_submap(std::span<const WallEstimate> fresh, const WallPattern& old, const KnownArea& known,
                     double reach_m);

/// Turns of the new walls that bring many of them onto the headings of old ones, besides no turn at all:
/// where no axes hold the heading, a long path may have turned it by degrees.
std::vector<double> likely_turns(std::span<const WallEstimate> fresh, std::span<const WallEstimate> old);

/// The submap's pose refined wall against wall from a good guess.
struct RefinedFit {
  Pose2 T_map_anchor;
  Mat3 information = Mat3::Zero();  ///< of (x, y, theta) from the matched walls, in `map`
};

RefinedFit refine_fit(const Submap& submap, const Pose2& T_map_anchor, const WallPattern& old,
                      const KnownArea& known);

}  // namespace aisle
