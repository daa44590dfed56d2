#pragma once

#include <optional>
#include <span>
#include <vector>

#include "floor_cells.hpp"
#include "oblique_segments.hpp"
#include "side_view.hpp"

namespace aisle {

/// A vertical line in a side view.
struct SideVertical {
  Vec2 top_px, bottom_px;
  double weight = 0;  ///< 0 to 1: long and of much contrast
};

/// A line towards the viewer, downwards to the right, that may be the foot of the right wall, and what speaks
/// for it and against it.
struct WallFoot {
  Vec2 point_px = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();  ///< unit vector; both parts > 0
  double from_px = 0, to_px = 0;   ///< where edges are seen on it, along `direction` from `point_px`

  double covered = 0;    ///< length of the edges on it, in widths of the picture
  double share = 0;      ///< of its length in the picture that edges cover
  double contrast = 0;   ///< mean size of the step across it [grey levels]
  double sign = 0;       ///< the same with its sign; < 0: darker beneath
  double feet = 0;       ///< vertical lines that end on it
  double crossings = 0;  ///< vertical lines that go on beneath it
  double followed = 0;   ///< share of its length beneath which other edges come before the floor's middle
  double on_floor = 0;   ///< share of its length beneath which there is floor
  double at_edge = 0;    ///< share of its length beneath which there is floor, and none above

  double support() const;
  double score() const;
  double v_at(double u_px) const {
    return point_px.y() + direction.y() / direction.x() * (u_px - point_px.x());
  }
  double slope_deg() const;
};

/// Looks for the line between floor and right wall of a side view.
class WallFootSearch {
 public:
  /// @param segments, verticals  turned into the view; the verticals from left to right
  /// @param floor  of the picture as it is, not of the view
  /// @return the best line, or the lower edge of its board; nullopt if none scores `score_min`
  std::optional<WallFoot> find(const SideView& view, const Vec2& vanishing_point_px,
                               std::span<const EdgeSegment> segments, std::span<const SideVertical> verticals,
                               const FloorCells& floor, double score_min);

 private:
  struct Seed {
    Vec2 point_px, direction;
    double length_px;
  };

  void gather_rays(std::span<const EdgeSegment> segments);
  void gather_seeds(std::span<const SideVertical> verticals);
  std::optional<WallFoot> fitted(const Seed& seed);
  bool is_possible(const WallFoot& foot) const;
  void measure(const SideView& view, WallFoot& foot) const;
  void measure_contrast(const SideView& view, WallFoot& foot) const;
  void measure_verticals(const SideView& view, WallFoot& foot) const;
  double contrast_along(const SideView& view, const SideVertical& vertical, double from_px,
                        double to_px) const;
  void measure_floor_side(const SideView& view, WallFoot& foot) const;
  void measure_floor(const SideView& view, WallFoot& foot) const;
  const WallFoot* lowest_of_like_score(double score_min) const;
  bool is_lower_edge(const WallFoot& foot, const WallFoot& upper) const;
  double depth_px(const WallFoot& foot) const;

  double width_px_ = 0, height_px_ = 0;
  Vec2 vanishing_point_px_ = Vec2::Zero();
  std::span<const SideVertical> verticals_;
  const FloorCells* floor_ = nullptr;
  std::vector<EdgeSegment> rays_;  ///< segments that point to the vanishing point from the right below
  std::vector<Seed> seeds_;
  std::vector<std::pair<double, double>> intervals_;
  std::vector<WallFoot> feet_;
};

}  // namespace aisle
