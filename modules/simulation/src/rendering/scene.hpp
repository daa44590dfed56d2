#pragma once

#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "rendering/light_baking.hpp"
#include "rendering/scene_plan.hpp"
#include "rendering/seen_panel.hpp"
#include "rendering/shading.hpp"

namespace aisle {

struct RenderedWorld::Scene {
  explicit Scene(const World& world);

  void place(std::span<const MovingBody> bodies);

  /// All that is ahead of a camera, hidden or not.
  std::vector<SeenPanel> seen_panels(const Viewpoint& view) const;
  /// What stands on the floor or hangs above it.
  bool is_above_floor(std::uint32_t panel_number) const;
  bool has_polished_floor() const;
  const ShadedSurface& surface(std::uint32_t panel_number) const;
  void find_blocked(const SegmentPacket& segments, Flags& blocked) const;
  const RayScene& what_stands() const { return standing_; }
  ShadingTables tables() const { return {materials_.all(), materials_.textures(), light_.texels.data()}; }

  SceneFrame frame;
  bool has_lamps = false;
  double ambient_light = 1;

 private:
  void light_body_surface(const Vec2& p_world, const Panel& panel, ShadedSurface& surface);

  Materials materials_;
  RayScene standing_;
  std::vector<Corners> standing_corners_;
  std::vector<ShadedSurface> standing_surfaces_;  ///< the first is the floor
  LightTexels light_;
  RayScene moving_;
  std::vector<Corners> moving_corners_;
  std::vector<ShadedSurface> moving_surfaces_;
  std::size_t standing_materials_ = 0, standing_texels_ = 0;
};

}  // namespace aisle
