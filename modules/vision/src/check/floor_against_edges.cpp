#include "check/floor_against_edges.hpp"

#include <cmath>
#include <limits>

namespace aisle {
namespace {

constexpr int kEdgePoints = 40;
constexpr std::uint8_t kMaskSet = 127;  // of a mask that was shrunk, pixels may be set in part

/// A point of the edge: 0 at its far end, 1 at its near one. Its points are few where the lens bends it, two
/// where not, and about evenly apart.
Vec2 point_at(const BaseLine& edge, double share) {
  const double place = share * static_cast<double>(edge.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), edge.size() - 2);
  return edge[i] + (place - static_cast<double>(i)) * (edge[i + 1] - edge[i]);
}

/// Unit vector from the wall to the floor.
Vec2 to_floor(const Vec2& far_px, const Vec2& near_px, bool is_right) {
  const Vec2 along = (near_px - far_px).normalized();
  return is_right ? Vec2(-along.y(), along.x()) : Vec2(along.y(), -along.x());
}

}  // namespace

double floor_side_px(const BaseLine& edge, bool is_right, const Vec2& point_px) {
  double nearest_px = std::numeric_limits<double>::infinity(), side_px = 0;
  for (std::size_t i = 1; i < edge.size(); ++i) {
    const double away_px = (point_px - (edge[i - 1] + edge[i]) / 2).norm();
    if (away_px >= nearest_px) continue;
    nearest_px = away_px;
    side_px = to_floor(edge[i - 1], edge[i], is_right).dot(point_px - edge[i - 1]);
  }
  return side_px;
}

double apart_px(const BaseLine& edge, const BaseLine& other) {
  double sum_px = 0;
  for (int i = 0; i < kEdgePoints; ++i) {
    const Vec2 point_px = point_at(edge, 0.5 + 0.5 * i / (kEdgePoints - 1));
    sum_px += std::abs(floor_side_px(other, true, point_px));
  }
  return sum_px / kEdgePoints;
}

double set_share_beside(const Image& mask, const BaseLine& edge, bool is_right, double offset_px) {
  int seen = 0, set = 0;
  const Vec2 aside_px = offset_px * to_floor(edge.front(), edge.back(), is_right);
  for (int i = 0; i < kEdgePoints; ++i) {
    // Nearer to the corridor's end the floor is narrower than the offset.
    const Vec2 point_px = point_at(edge, 0.25 + 0.75 * i / (kEdgePoints - 1)) + aside_px;
    const long u = std::lround(point_px.x()), v = std::lround(point_px.y());
    if (u < 0 || v < 0 || u >= mask.width_px || v >= mask.height_px) continue;
    ++seen;
    set += static_cast<int>(mask.row(static_cast<int>(v))[u] != 0);
  }
  return seen > 0 ? static_cast<double>(set) / seen : 0;
}

double overlap_of(const Image& a, const Image& b) {
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    both += static_cast<std::size_t>(a.bytes[i] > kMaskSet && b.bytes[i] > kMaskSet);
    either += static_cast<std::size_t>(a.bytes[i] > kMaskSet || b.bytes[i] > kMaskSet);
  }
  return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 1;
}

}  // namespace aisle
