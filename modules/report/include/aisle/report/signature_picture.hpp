#pragma once

#include <string>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {

/// Walls and what they mark on the axes.
struct SignedPattern {
  std::vector<Segment2> walls;
  Signature x, y;
};

/// A view laid against what was learned, as in C99 Fig. 5: both patterns, beside them their signatures on the
/// y axis, below them those on the x axis. Everything in `map` [m].
struct SignaturePicture {
  SignedPattern learned, sensed;
  std::string title;
  std::string caption;  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const SignaturePicture& picture);

}  // namespace aisle
