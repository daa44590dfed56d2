#pragma once

#include <string>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/matching/signature.hpp"

namespace aisle {

/// Walls and their signatures on the axes.
struct SignedPattern {
  std::vector<Segment2> walls;
  Signature x, y;
};

/// A view compared with the learned pattern, as in C99 Fig. 5: both patterns, with their signatures on the y
/// axis beside them and those on the x axis below. Everything in `map` [m].
struct SignaturePicture {
  SignedPattern learned, sensed;
  std::string title;
  std::string caption;  ///< one line below the title
};

/// The picture as an SVG document. Same picture, same bytes.
std::string svg(const SignaturePicture& picture);

}  // namespace aisle
