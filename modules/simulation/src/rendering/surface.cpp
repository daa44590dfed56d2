#include "rendering/surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace aisle {
namespace {

std::array<float, 4> coordinate(const Vec3& gradient, double offset) {
  return {static_cast<float>(gradient.x()), static_cast<float>(gradient.y()),
          static_cast<float>(gradient.z()), static_cast<float>(offset)};
}

/// Share of the distance along `edge` from `corner`, or metres counted from the world's origin, so that
/// patterns go on from one piece to the next.
std::array<float, 4> pattern_coordinate(const Panel& panel, const Vec3& edge, const SceneFrame& frame) {
  const Vec3 corner = frame(panel.corner);
  if (panel.pattern == Panel::Pattern::kFilling) {
    const Vec3 gradient = edge / edge.squaredNorm();
    return coordinate(gradient, -gradient.dot(corner));
  }
  const Vec3 direction = edge.normalized();
  return coordinate(direction, direction.dot(panel.corner - corner));
}

}  // namespace

Vec3 Panel::outside() const {
  return up.cross(along).normalized();
}

Corners Panel::corners() const {
  return cut_out.value_or(Corners{corner, corner + along, corner + along + up, corner + up});
}

ShadedSurface shaded_surface_of(const Panel& panel, const SceneFrame& frame) {
  ShadedSurface surface;
  const Vec3 normal = panel.outside();
  for (int i = 0; i < 3; ++i) surface.normal[static_cast<std::size_t>(i)] = static_cast<float>(normal[i]);
  surface.plane = static_cast<float>(normal.dot(frame(panel.corner)));
  surface.u = pattern_coordinate(panel, panel.along, frame);
  surface.v = pattern_coordinate(panel, panel.up, frame);
  surface.material = panel.material;
  const double rise_along = panel.along.z(), rise_up = panel.up.z(), z = panel.corner.z();
  surface.bottom = static_cast<float>(z + std::min(0.0, rise_along) + std::min(0.0, rise_up));
  surface.top = static_cast<float>(z + std::max(0.0, rise_along) + std::max(0.0, rise_up));
  return surface;
}

}  // namespace aisle
