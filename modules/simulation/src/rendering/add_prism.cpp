#include "rendering/scene_plan.hpp"

namespace aisle {
namespace {

Vec3 at_height(const Vec2& p, double height_m) {
  return {p.x(), p.y(), height_m};
}

/// The level square around the outline, with its outside up or down.
Panel level_square(const std::vector<Vec2>& outline, double height_m, bool faces_up, int material) {
  Vec2 min = outline.front(), max = outline.front();
  for (const Vec2& p : outline) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  const Vec2 size = max - min;
  return {.corner = at_height(faces_up ? Vec2(max.x(), min.y()) : min, height_m),
          .along = {faces_up ? -size.x() : size.x(), 0, 0},
          .up = {0, size.y(), 0},
          .material = material};
}

/// The outline filled with pieces of four corners.
void add_level(const Prism& prism, double height_m, bool faces_up, int material, Panels& panels) {
  const std::vector<Vec2>& outline = prism.outline;
  Panel panel = level_square(outline, height_m, faces_up, material);
  for (std::size_t i = 1; i + 1 < outline.size(); i += 2) {
    const std::size_t last = std::min(i + 2, outline.size() - 1);
    panel.cut_out = {at_height(outline[0], height_m), at_height(outline[i], height_m),
                     at_height(outline[i + 1], height_m), at_height(outline[last], height_m)};
    panels.push_back(panel);
  }
}

}  // namespace

void add_prism(const Prism& prism, int material, Panels& panels) {
  for (std::size_t i = 0; i < prism.outline.size(); ++i) {
    const Vec2& start = prism.outline[i];
    const Vec2 side = prism.outline[(i + 1) % prism.outline.size()] - start;
    panels.push_back({.corner = at_height(start, prism.bottom_m),
                      .along = at_height(side, 0),
                      .up = {0, 0, prism.top_m - prism.bottom_m},
                      .material = material});
  }
  add_level(prism, prism.top_m, true, material, panels);
  if (prism.bottom_m > 0) add_level(prism, prism.bottom_m, false, material, panels);
}

}  // namespace aisle
