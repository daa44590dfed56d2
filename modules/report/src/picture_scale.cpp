#include "picture_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr double kLongSide_px = 1600;
constexpr double kWidthMin_px = 1000;  ///< room for title and legend
constexpr double kPxPerMetreMax = 150;
constexpr double kEmptySide_m = 10;

}  // namespace

Vec2 PictureScale::to_paper(const Vec2& p_map) const {
  const Vec2 p = p_paper_low + px_per_m * Vec2(p_map.x() - low.x(), low.y() - p_map.y());
  return {std::round(8 * p.x()) / 8, std::round(8 * p.y()) / 8};
}

PictureScale fit_scale(const MapPicture& picture) {
  PictureContent content;
  for (const Wall& wall : picture.walls.walls) {
    content.add(wall.segment.start);
    content.add(wall.segment.end);
  }
  for (const Pose2& pose : picture.path) content.add(pose.position());
  return fit_scale(content);
}

PictureScale fit_scale(PictureContent content) {
  if (content.low.x() > content.high.x()) {
    content.add(Vec2::Zero());
    content.add(Vec2::Constant(kEmptySide_m));
  }
  const Vec2 size_m = (content.high - content.low).cwiseMax(1);
  const double around_px = 2 * kMargin_px, above_and_below_px = kHeader_px + kFooter_px;
  PictureScale scale;
  scale.low = content.low;
  scale.high = content.high;
  scale.px_per_m = std::min({(kLongSide_px - around_px) / size_m.x(),
                             (kLongSide_px - above_and_below_px) / size_m.y(), kPxPerMetreMax});
  const Vec2 map_px = scale.px_per_m * size_m;
  const double width_px = std::max(std::round(map_px.x() + around_px), kWidthMin_px);
  scale.width_px = static_cast<int>(width_px);
  scale.height_px = static_cast<int>(std::round(map_px.y() + above_and_below_px));
  scale.p_paper_low = {std::round((width_px - map_px.x()) / 2), std::round(kHeader_px + map_px.y())};
  return scale;
}

double round_length(double length) {
  const double decade = std::pow(10, std::floor(std::log10(length)));
  for (const double digit : std::array{5.0, 2.0}) {
    if (digit * decade <= length) return digit * decade;
  }
  return decade;
}

}  // namespace aisle
