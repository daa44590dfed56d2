#pragma once
/// The part of a picture that the vehicle can drive on: the floor as far as it looks like the floor in front.

#include <optional>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct RegionParams {
  int columns = 160;
  double patch_share = 0.2;
  double quiet_step = 2;
  double colour_weight = 2;
  double look_weight = 0.04;
  double far_share = 0.3;
  double far_cost = 12;
  double strange_colour = 40;

  void describe(FieldList& fields);
};

/// Where the route is.
struct RouteRegion {
  Image mask;        ///< as large as the picture: 255 on the route, else 0
  double share = 0;  ///< of the picture's pixels
};

/// Grows the route region from below (L96 sections 2.2 and 3.1). What the route looks like is learned from a
/// square patch in the middle of the lowest rows, which must therefore see the floor. Beyond the paper, the
/// region follows slow changes of brightness and stops at edges: every place belongs to the floor or to the
/// rest, whichever reaches it over the lesser steps of brightness and colour, the rest starting from the
/// picture's top. Colour pictures are used in colour. Neither intrinsics nor the horizon need be known; the
/// camera stands upright.
/// @return an empty mask where there is no picture
RouteRegion find_route_region(const Image& picture, const RegionParams& params = {});

/// The middle of the route as L96 Algorithm 4 finds it.
struct RouteMiddle {
  Vec2 far_px = Vec2::Zero();   ///< A: middle of the widest part of the region on the upper scan line
  Vec2 near_px = Vec2::Zero();  ///< C: the same on the lower one
  Vec2 mean_px = Vec2::Zero();  ///< B: halfway between the two
};

/// @param far_row, near_row  the scan lines; rows of the mask
/// @return nullopt unless both lines meet the region
std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row);

}  // namespace aisle
