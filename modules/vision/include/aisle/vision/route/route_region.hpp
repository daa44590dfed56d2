#pragma once
/// The part of an image that the vehicle can drive on: the floor as far as it looks like the floor in front.

#include <memory>
#include <optional>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Costs are in grey levels of a tone scale, on which equal steps look equally large: 255 sqrt(g / 255).
struct RegionParams {
  int columns = 80;
  double quiet_step = 3;
  double texture_factor = 1.5;
  double texture_max = 12;
  double colour_weight = 2;
  double unmatched_colour = 80;
  double horizon_share = 0.45;
  double near_reach = 0.12;
  double floor_cost = 160;
  double far_share = 0.3;
  double side_share = 0.2;
  double rest_cost = 400;
  double alike_cost = 10;

  void describe(FieldList& fields);
};

/// The part of an image that is route.
struct RouteRegion {
  Image mask;        ///< as large as the image: 255 on the route, else 0
  double share = 0;  ///< of the image's pixels
};

/// Free-space segmentation: grows the route region of images from below (L96 sections 2.2 and 3.1). The
/// middle of the image's lower edge is taken for floor. Beyond the paper, brightness may drift slowly over
/// the floor, and the region stops at edges: each cell belongs to the floor, growing from below, or to the
/// rest, growing from above, whichever reaches it over the smaller steps of brightness and colour. Both may
/// also start elsewhere, at a cost that grows with the distance from where they are expected, so that
/// reflections and tiles do not stop them. Colour images are used in colour: what differs much in colour from
/// the floor in front is not floor. Neither intrinsics nor the horizon need be known; the camera is upright
/// and looks about level or down. Memory is kept from image to image.
class RouteRegionFinder {
 public:
  explicit RouteRegionFinder(const RegionParams& params = {});
  ~RouteRegionFinder();
  RouteRegionFinder(RouteRegionFinder&&) noexcept;
  RouteRegionFinder& operator=(RouteRegionFinder&&) noexcept;

  /// @param mask  becomes as large as the image: 255 on one connected region, else 0
  void find(const Image& image, Image& mask);

 private:
  std::unique_ptr<class RegionGrowth> growth_;
};

/// The route region of a single image.
RouteRegion find_route_region(const Image& image, const RegionParams& params = {});

/// The middle of the route as L96 Algorithm 4 finds it.
struct RouteMiddle {
  Vec2 far_px = Vec2::Zero();   ///< A: middle of the widest part of the region on the upper scan line
  Vec2 near_px = Vec2::Zero();  ///< C: the same on the lower one
  Vec2 mean_px = Vec2::Zero();  ///< B: halfway between the two
};

/// @param far_row, near_row  the scan lines; rows of the mask
/// @return nullopt unless both lines meet the region
std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row);
/// The same from `begin_column` to before `end_column`; the rest is masked.
std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row, int begin_column,
                                             int end_column);

}  // namespace aisle
