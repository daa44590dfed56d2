#pragma once

#include <cmath>
#include <optional>

#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// An image as it is, or mirrored: the left wall of a corridor is searched as the right wall of its mirror
/// image.
class SideView {
 public:
  SideView(const Image& grey, bool mirrored) : grey_(&grey), mirrored_(mirrored) {}

  int width_px() const { return grey_->width_px; }
  int height_px() const { return grey_->height_px; }
  bool mirrored() const { return mirrored_; }

  /// From the image to this view and back.
  Vec2 turned(const Vec2& point_px) const {
    return mirrored_ ? Vec2(grey_->width_px - 1 - point_px.x(), point_px.y()) : point_px;
  }

  bool contains(int u, int v) const { return u >= 0 && v >= 0 && u < width_px() && v < height_px(); }
  int at(int u, int v) const { return grey_->row(v)[mirrored_ ? grey_->width_px - 1 - u : u]; }

  /// Whether the pixel nearest to a point is in the image.
  bool contains(const Vec2& point_px) const { return contains(nearest(point_px.x()), nearest(point_px.y())); }

  /// By how much the pixel nearest to one point is brighter than the one nearest to another; 0 if one of
  /// them is outside the image.
  std::optional<int> step(const Vec2& from_px, const Vec2& to_px) const {
    if (!contains(from_px) || !contains(to_px)) return std::nullopt;
    return at(nearest(to_px.x()), nearest(to_px.y())) - at(nearest(from_px.x()), nearest(from_px.y()));
  }

  /// Between the pixels; the point must have a pixel to each side.
  double between(const Vec2& point_px) const {
    const int u = static_cast<int>(point_px.x()), v = static_cast<int>(point_px.y());
    const double right = point_px.x() - u, below = point_px.y() - v;
    const double upper = at(u, v) + right * (at(u + 1, v) - at(u, v));
    const double lower = at(u, v + 1) + right * (at(u + 1, v + 1) - at(u, v + 1));
    return upper + below * (lower - upper);
  }

 private:
  static int nearest(double px) { return static_cast<int>(std::lround(px)); }

  const Image* grey_;
  bool mirrored_;
};

}  // namespace aisle
