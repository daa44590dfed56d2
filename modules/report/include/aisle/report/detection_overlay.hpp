#pragma once
/// What a detector found, drawn over the camera image. The drawing has the size of the image.

#include <optional>
#include <span>
#include <string>

#include "aisle/core/image.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "aisle/vision/floor/line_finder.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"
#include "aisle/vision/route/route_region.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"

namespace aisle {

/// Lines cyan, floor points red. @return a PNG file
std::string verticals_overlay_png(const Image& image, std::span<const VerticalLine> verticals);

/// The right line orange, the left one magenta, a yellow ring at the vanishing point. @return a PNG file
std::string base_lines_overlay_png(const Image& image, const BaseLines& lines);

/// Stripes green with yellow rings at their corners. @return a PNG file
std::string stripes_overlay_png(const Image& image, std::span<const LaserStripe> stripes);

/// The region green, its outline brighter; the scan lines' midpoints A and C yellow and their mean B red.
/// @return a PNG file
std::string region_overlay_png(const Image& image, const RouteRegion& region,
                               const std::optional<RouteMiddle>& middle);

/// All that a vehicle drives by, in one drawing: the free floor green, wall-floor edges as above, vertical
/// lines cyan, their floor points red. @param floor  as large as the image: not 0 on the free floor
/// @return a PNG file
std::string features_overlay_png(const Image& image, const FoundLines& lines, const Image& floor);

}  // namespace aisle
