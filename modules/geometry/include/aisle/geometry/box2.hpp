#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A rectangle along the axes of its frame; empty until it is extended by a point.
using Box2 = Eigen::AlignedBox2d;

/// The smallest box that holds all segments; empty: there are none.
/// @param segment_of  the segment of an element, such as &Wall::segment; else the elements are segments
template <class Elements, class SegmentOf = std::identity>
Box2 box_around(const Elements& elements, SegmentOf segment_of = {}) {
  Box2 box;
  for (const auto& element : elements) {
    const Segment2& segment = std::invoke(segment_of, element);
    box.extend(segment.start).extend(segment.end);
  }
  return box;
}

}  // namespace aisle
