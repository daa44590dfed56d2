#include "rendering/scene.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

/// Set in the number of a panel that moves.
constexpr std::uint32_t kMoves = 0x80000000;

Panels standing_panels(const World& world, Materials& materials) {
  Panels panels;
  add_rooms(world, materials, panels);
  add_doors(world, materials, panels);
  add_furnishing(world, materials, panels);
  return panels;
}

std::vector<ShadedSurface> surfaces_of(const Panels& panels, const SceneFrame& frame) {
  std::vector<ShadedSurface> surfaces;
  surfaces.reserve(panels.size());
  for (const Panel& panel : panels) surfaces.push_back(shaded_surface_of(panel, frame));
  return surfaces;
}

std::vector<Corners> corners_of(const Panels& panels, const SceneFrame& frame) {
  std::vector<Corners> all;
  all.reserve(panels.size());
  for (const Panel& panel : panels) {
    Corners corners = panel.corners();
    for (Vec3& corner : corners) corner = frame(corner);
    all.push_back(corners);
  }
  return all;
}

}  // namespace

RenderedWorld::Scene::Scene(const World& world)
    : frame{extent_of(world).centre()},
      has_lamps(!world.lamps.empty()),
      ambient_light(has_lamps ? world.ambient_light : 1),
      materials_(world.texture_seed),
      standing_({}, frame),
      moving_({}, frame) {
  const Panels panels = standing_panels(world, materials_);
  standing_ = RayScene(panels, frame);
  standing_corners_ = corners_of(panels, frame);
  standing_surfaces_ = surfaces_of(panels, frame);
  light_ = bake_light(world, panels, standing_, frame, standing_surfaces_);
  standing_materials_ = materials_.all().size();
  standing_texels_ = light_.texels.size();
}

void RenderedWorld::Scene::place(std::span<const MovingBody> bodies) {
  materials_.keep(standing_materials_);
  light_.texels.resize(standing_texels_);
  Panels panels;
  std::vector<Vec2> places;
  for (const MovingBody& body : bodies) {
    add_body(body, materials_, panels);
    places.resize(panels.size(), body.T_world_body.position());
  }
  moving_ = RayScene(panels, frame);
  moving_corners_ = corners_of(panels, frame);
  moving_surfaces_ = surfaces_of(panels, frame);
  for (std::size_t i = 0; i < panels.size(); ++i)
    light_body_surface(places[i], panels[i], moving_surfaces_[i]);
}

/// One light for the whole piece: as on the floor below it, less on its sides.
void RenderedWorld::Scene::light_body_surface(const Vec2& p_world, const Panel& panel,
                                              ShadedSurface& surface) {
  constexpr float kOnSides = 0.65f, kFromLeft = 0.15f;
  const LightMap& floor = standing_surfaces_.front().outside;
  const std::array<float, 4>&u = standing_surfaces_.front().u, &v = standing_surfaces_.front().v;
  const Eigen::Vector2f p = (p_world - frame.p_world_origin).cast<float>();
  const auto texel = [&](const std::array<float, 4>& c, float per_unit, float at_0, int count) {
    const long nearest = std::lround((c[0] * p.x() + c[1] * p.y() + c[3]) * per_unit + at_0);
    return static_cast<int>(std::clamp(nearest, 0L, count - 1L));
  };
  const int column = texel(u, floor.columns_per_u, floor.column_at_0, floor.columns);
  const int row = texel(v, floor.rows_per_v, floor.row_at_0, floor.rows);
  const std::uint32_t both =
      light_.texels[static_cast<std::size_t>(floor.first_texel + row * floor.columns + column)];
  const Vec3 outside = panel.outside();
  const float share = outside.z() > 0.5 ? 1 : kOnSides + kFromLeft * static_cast<float>(outside.y());
  constexpr float kPerStep = LightTexels::kLightMax / 65535;
  surface.outside = {.first_texel = static_cast<int>(light_.texels.size())};
  surface.inside = surface.outside;
  light_.texels.push_back(light_texel(share * kPerStep * static_cast<float>(both & 0xffff),
                                      share * kPerStep * static_cast<float>(both >> 16)));
}

std::vector<SeenPanel> RenderedWorld::Scene::seen_panels(const Viewpoint& view) const {
  std::vector<SeenPanel> seen;
  const auto add = [&](const std::vector<Corners>& all, std::uint32_t mark) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto panel = seen_panel(all[i], view, static_cast<std::uint32_t>(i) | mark)) {
        seen.push_back(*panel);
      }
    }
  };
  add(standing_corners_, 0);
  add(moving_corners_, kMoves);
  return seen;
}

bool RenderedWorld::Scene::is_above_floor(std::uint32_t panel_number) const {
  constexpr float kPaper_m = 0.01f;
  return surface(panel_number).top > kPaper_m;
}

bool RenderedWorld::Scene::has_polished_floor() const {
  return materials_.all()[static_cast<std::size_t>(standing_surfaces_.front().material)].gloss > 0;
}

void RenderedWorld::Scene::find_blocked(const SegmentPacket& segments, Flags& blocked) const {
  standing_.find_blocked(segments, blocked);
  moving_.find_blocked(segments, blocked);
}

const ShadedSurface& RenderedWorld::Scene::surface(std::uint32_t panel_number) const {
  return (panel_number & kMoves) != 0 ? moving_surfaces_[panel_number & ~kMoves]
                                      : standing_surfaces_[panel_number];
}

}  // namespace aisle
