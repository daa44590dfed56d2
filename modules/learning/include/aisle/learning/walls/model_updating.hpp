#pragma once
/// The learned model of C99: segments parallel to the axes, updated by Algorithm 3.

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A segment parallel to an axis: the three-tuple (y_c, x_1, x_2) or (x_c, y_1, y_2) of C99 section 3.2.
struct OrthogonalSegment {
  bool along_x = true;
  double coordinate_m = 0;  ///< y of a segment along x, x of one along y
  Interval extent;          ///< along the segment [m]
  int min_occurrences = 0;  ///< how often the end point at extent.min was seen again (step 6)
  int max_occurrences = 0;

  Segment2 segment() const;
};

struct ModelUpdateParams {
  double across_m = 0.15;  ///< c1: parallel segments nearer than this are one wall
  double end_m = 0.30;     ///< c2, c3: end points nearer than this are one end
};

/// Algorithm 3: merges the view N into the part L' of the model. Segments of one direction that are within c1
/// of each other and overlap, or coincide within c2 at both ends, are united: the extent spans all of them,
/// or is their mean where all coincide, and the coordinate is their mean. Whole groups are united at once, so
/// the result does not depend on the order of N or L', and merging a view into the model that it made changes
/// only the counts (unless walls are so close to each other that their means are within c1 though they are
/// not).
std::vector<OrthogonalSegment> update_model(std::span<const OrthogonalSegment> model,
                                            std::span<const OrthogonalSegment> view,
                                            const ModelUpdateParams& params);

}  // namespace aisle
