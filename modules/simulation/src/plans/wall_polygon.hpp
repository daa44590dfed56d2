#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A wall on a line, before its ends are known exactly.
struct StraightPiece {
  Vec2 on_line = Vec2::Zero();
  Vec2 along = Vec2::UnitX();  ///< of length 1
  Vec2 first = Vec2::Zero();   ///< near its start, perhaps off the line
  Vec2 last = Vec2::Zero();    ///< near its end, where the next piece begins

  Vec2 projected(const Vec2& p) const { return on_line + (p - on_line).dot(along) * along; }
};

/// Lengthens or shortens pieces that follow each other in a circle until they meet; where two lines do not
/// meet nearby, a short piece joins them. Neighbours on one line become one; a piece that has no length left
/// is left out. Lengths are cells.
std::vector<Segment2> closed_polygon(std::vector<StraightPiece> pieces);

}  // namespace aisle
