#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A candidate for the right wall's wall-floor edge: a line towards the viewer, downwards to the right, with
/// the evidence for and against it.
struct WallFloorEdge {
  Vec2 point_px = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();  ///< unit vector; both parts > 0
  double from_px = 0, to_px = 0;   ///< where edges are seen on it, along `direction` from `point_px`

  double covered = 0;       ///< length of the edges on it, in widths of the image
  double share = 0;         ///< of its length in the image that edges cover
  double contrast = 0;      ///< mean size of the step across it [grey levels]
  double sign = 0;          ///< mean step with its sign; < 0: darker beneath
  double floor_points = 0;  ///< vertical lines that end on it
  double crossings = 0;     ///< vertical lines that go on beneath it
  double followed = 0;      ///< share of its length beneath which other edges come before the floor's middle
  double on_floor = 0;      ///< share of its length beneath which there is floor
  double at_edge = 0;       ///< share of its length beneath which there is floor, and none above

  /// Whether most of its length steps in one direction, as one edge of a board does.
  bool has_clear_sign() const;
  double support() const;
  double score() const;
  double v_at(double u_px) const {
    return point_px.y() + direction.y() / direction.x() * (u_px - point_px.x());
  }
  double slope_deg() const;
};

}  // namespace aisle
