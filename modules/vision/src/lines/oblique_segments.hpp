#pragma once

#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"
#include "lines/edge_chains.hpp"
#include "lines/straight_pieces.hpp"

namespace aisle {

/// A straight edge in an image.
struct EdgeSegment {
  Vec2 left_px = Vec2::Zero(), right_px = Vec2::Zero();  ///< its ends; left.x <= right.x
  double contrast = 0;                                   ///< brightness beneath it less that above it

  Vec2 middle_px() const { return 0.5 * (left_px + right_px); }
  double length_px() const { return (right_px - left_px).norm(); }
  Vec2 direction() const { return (right_px - left_px).normalized(); }
};

/// Finds straight edges of all directions but the vertical and the horizontal: steep ones as upright lines of
/// the halved image, flat ones as upright lines of the same image with rows and columns exchanged.
class ObliqueSegmentFinder {
 public:
  /// Replaces `segments` by those of an image.
  void find(const Image& grey, std::vector<EdgeSegment>& segments);

 private:
  void halve(const Image& grey);
  void add_segments(const Image& image, bool transposed, std::vector<EdgeSegment>& segments);

  int shrink_ = 2;
  Image small_;
  Image transposed_;
  EdgeLinker linker_;
  PieceCutter cutter_;
  std::vector<UprightLine> lines_;
};

}  // namespace aisle
