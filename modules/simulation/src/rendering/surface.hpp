#pragma once
/// What a rendered world is made of: flat pieces, each with a material that gives it a pattern.

#include <array>
#include <optional>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "rendering/texture.hpp"

namespace aisle {

/// A texture laid over a surface; it makes the brightness up to `contrast` darker or brighter.
struct PatternLayer {
  int texture = 0;
  float texels_per_u = 0;
  float texels_per_v = 0;
  float contrast = 0;  ///< 0: not there
};

/// A grid of dark lines between tiles or panels.
struct Joints {
  float period_u = 0;  ///< 0: none
  float period_v = 0;
  float width = 0;
  float darkness = 0;   ///< share of the brightness that a joint lacks
  float variation = 0;  ///< how much one tile may differ from another
};

/// Pattern coordinates (u, v) are metres, or shares of the piece where an image fills it.
struct Material {
  float brightness = 0.5f;
  PatternLayer detail;
  PatternLayer unevenness;
  Joints joints;
  float chessboard_columns = 0;  ///< squares with the margins; u and v count squares then. 0: no chessboard
  float chessboard_rows = 0;
  float glow = 0;   ///< light that it sends out when lamps are on
  float gloss = 0;  ///< of the light that a polished surface mirrors, this share; the floor only
};

/// Corners of a convex piece, in turn around it.
using Corners = std::array<Vec3, 4>;

/// A flat piece of the world: a parallelogram. Seen from outside, `along` runs to the left if `up` runs
/// upwards: outside is where up x along points.
struct Panel {
  enum class Pattern { kMetres, kFilling };

  Vec3 corner = Vec3::Zero();
  Vec3 along = Vec3::UnitX();
  Vec3 up = Vec3::UnitZ();
  int material = 0;
  Pattern pattern = Pattern::kMetres;
  bool is_two_sided = false;  ///< seen and lit from both sides
  /// Corners in turn, if only this part of the parallelogram is there.
  std::optional<Corners> cut_out;

  Vec3 outside() const;
  Corners corners() const;
};

/// Light that falls on one side of a surface, on a grid of texels.
struct LightMap {
  int first_texel = 0;
  int columns = 1;
  int rows = 1;
  float columns_per_u = 0, column_at_0 = 0;
  float rows_per_v = 0, row_at_0 = 0;
};

/// A panel as the shading kernels want it: single precision, in the scene's frame.
struct ShadedSurface {
  std::array<float, 3> normal{};
  float plane = 0;                ///< normal . p = plane
  std::array<float, 4> u{}, v{};  ///< pattern coordinates of p: u[0..2] . p + u[3]
  int material = 0;
  LightMap outside, inside;
  float bottom = 0, top = 0;  ///< heights between which it lies
};

/// Frame of a scene: axes of the world, the origin near the building's middle, where single precision is
/// finest.
struct SceneFrame {
  Vec2 p_world_origin = Vec2::Zero();

  Vec3 operator()(const Vec3& p_world) const {
    return p_world - Vec3(p_world_origin.x(), p_world_origin.y(), 0);
  }
};

ShadedSurface shaded_surface_of(const Panel& panel, const SceneFrame& frame);

}  // namespace aisle
