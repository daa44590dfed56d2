#pragma once

#include "aisle/core/image.hpp"
#include "aisle/vision/floor/base_lines.hpp"

namespace aisle {

/// How far a point is on the floor's side of a wall-floor edge, across it [px]; < 0: on the wall's side.
double floor_side_px(const BaseLine& edge, bool is_right, const Vec2& point_px);

/// How far an edge is from another of the same image: the mean distance of its near half's points [px].
double apart_px(const BaseLine& edge, const BaseLine& other);

/// Share of an edge beneath which, or above which, by `offset_px` the mask is set; 0 if all is out of view.
/// @param offset_px  > 0: beneath, on the floor's side
double set_share_beside(const Image& mask, const BaseLine& edge, bool is_right, double offset_px);

/// Intersection over union of two masks of one size; 1 if both are empty.
double overlap_of(const Image& a, const Image& b);

}  // namespace aisle
