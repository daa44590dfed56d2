#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// Free floor with its sides along the axes [m]; min < max.
struct Rectangle {
  Vec2 min = Vec2::Zero();
  Vec2 max = Vec2::Zero();

  Vec2 centre() const { return (min + max) / 2; }
  Vec2 size() const { return max - min; }
  bool contains(const Vec2& p) const {
    return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
  }
  bool overlaps(const Rectangle& other) const {
    return (min.array() < other.max.array()).all() && (other.min.array() < max.array()).all();
  }
  Rectangle grown(double by_m) const { return {min - Vec2::Constant(by_m), max + Vec2::Constant(by_m)}; }
};

/// Walls around the floor that the rectangles cover together, free on the left; coordinates to the
/// millimetre. Closed polygons, each side starting where the one before ends. Rectangles that only touch at a
/// corner are not connected.
std::vector<Segment2> walls_around(std::span<const Rectangle> rectangles);

}  // namespace aisle
