#include "rendering/light_baking.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr double kTexel_m = 0.15;
constexpr std::size_t kTexelsMax = 3'000'000;
constexpr double kFromEdge_m = 0.015;  ///< light is not computed nearer to an edge: something may meet there
constexpr float kAboveSurface_m = 2e-3f;
constexpr double kLampReach_m = 8;
constexpr double kOpen_m = 1.2;  ///< what is farther away takes no light that comes from everywhere
constexpr float kBuried = 0.2f;  ///< less light from everywhere: the place is inside something

struct Light {
  float from_everywhere = 0;
  float from_lamps = 0;
};

/// One side of a surface, to be lit.
struct PanelSide {
  const Panel* panel = nullptr;
  LightMap* map = nullptr;
  Vec3 normal = Vec3::UnitZ();
};

/// A lamp in the scene's frame.
struct LampPlace {
  Vec3 centre, half_length, half_width;
  double strength = 0;  ///< power times area
};

std::vector<LampPlace> lamp_places(const World& world, const SceneFrame& frame) {
  constexpr double kBelowCeiling_m = 0.02;
  std::vector<LampPlace> places;
  for (const Lamp& lamp : world.lamps) {
    const Vec2 along = unit(lamp.heading_rad) * lamp.length_m / 2,
               across = left_normal(unit(lamp.heading_rad)) * lamp.width_m / 2;
    places.push_back({frame({lamp.centre.x(), lamp.centre.y(), world.ceiling_m - kBelowCeiling_m}),
                      {along.x(), along.y(), 0},
                      {across.x(), across.y(), 0},
                      lamp.power * lamp.length_m * lamp.width_m});
  }
  return places;
}

/// Positions 0 to 1 along a side of a map, all a little inside it.
double inset(int i, int count, double length_m) {
  const double edge = std::min(kFromEdge_m / length_m, 0.25);
  return count == 1 ? 0.5 : edge + (1 - 2 * edge) * i / (count - 1);
}

/// The part of a number after the point.
double fraction(double value) {
  return value - std::floor(value);
}

/// Directions over a surface, spread as light falls on it: (cosine, sine) times the radius, and the height.
struct Spread {
  std::array<Vec3, kLanes> directions;

  Spread() {
    for (int k = 0; k < kLanes; ++k) {
      const double height = std::sqrt((k + 0.5) / kLanes), radius = std::sqrt(1 - height * height);
      const Vec2 level = radius * unit(2 * kPi * fraction(0.6180339887 * k));
      directions[static_cast<std::size_t>(k)] = {level.x(), level.y(), height};
    }
  }
};

class Baker {
 public:
  Baker(const World& world, const RayScene& scene, const SceneFrame& frame)
      : scene_(scene), lamps_(lamp_places(world, frame)), seed_(world.texture_seed) {}

  Light at(const PanelSide& side, const Vec3& p_scene, const Vec3& step_along, const Vec3& step_up,
           std::uint64_t texel) const {
    Random random(seed_ ^ (texel * 0x9e3779b97f4a7c15u));
    Light light{openness(side.normal, p_scene, random.uniform()), 0};
    if (light.from_everywhere < kBuried) return light;
    SegmentPacket segments{};
    Floats strengths{};
    int lanes = 0;
    for (const LampPlace& lamp : lamps_) {
      if (!reaches(lamp, side.normal, p_scene)) continue;
      const double shift_along = random.uniform(), shift_across = random.uniform();
      for (int k = 0; k < kRaysPerLamp; ++k, ++lanes) {
        const double along = fraction(0.125 * k + shift_along), across = fraction(0.618 * k + shift_across);
        const Vec3 from = p_scene + (fraction(0.755 * k + shift_along) - 0.5) * step_along +
                          (fraction(0.570 * k + shift_across) - 0.5) * step_up;
        const Vec3 to =
            lamp.centre + (2 * along - 1) * lamp.half_length + (2 * across - 1) * lamp.half_width - from;
        set(segments, lanes, from, to);
        strengths.at[lanes] = strength(lamp, side.normal, to);
        segments.asked.at[lanes] = strengths.at[lanes] > 0 ? -1 : 0;
      }
      if (lanes == kLanes) {
        light.from_lamps += unblocked(segments, strengths);
        strengths = {};
        segments = {};
        lanes = 0;
      }
    }
    if (lanes > 0) light.from_lamps += unblocked(segments, strengths);
    return light;
  }

 private:
  static constexpr int kRaysPerLamp = 8;

  /// How far one sees around, weighted as light falls on the surface.
  float openness(const Vec3& normal, const Vec3& p, double turn) const {
    static const Spread spread;
    const Vec3 one = normal.unitOrthogonal(), other = normal.cross(one);
    const Vec2 turned = unit(2 * kPi * turn);
    const Vec3 side = turned.x() * one + turned.y() * other, across = turned.x() * other - turned.y() * one;
    SegmentPacket segments;
    for (int k = 0; k < kLanes; ++k) {
      const Vec3& d = spread.directions[static_cast<std::size_t>(k)];
      set(segments, k, p, kOpen_m * (d.x() * side + d.y() * across + d.z() * normal));
    }
    Floats shares;
    scene_.free_shares(segments, shares);
    float sum = 0;
    for (const float share : shares.at) sum += std::sqrt(share);
    return sum / kLanes;
  }

  static bool reaches(const LampPlace& lamp, const Vec3& normal, const Vec3& p) {
    const Vec3 reach = lamp.centre - p;
    const double behind_m = lamp.half_length.norm() + lamp.half_width.norm();
    return reach.z() > 0 && reach.squaredNorm() < kLampReach_m * kLampReach_m &&
           normal.dot(reach) > -behind_m;
  }

  /// What one of the rays to a lamp brings if nothing blocks it; nothing from beyond the lamp's reach.
  static float strength(const LampPlace& lamp, const Vec3& normal, const Vec3& to) {
    const double falling = std::max(0.0, to.z()), facing = std::max(0.0, normal.dot(to));
    const double squared = to.squaredNorm();
    const double fading = std::clamp(4 * (1 - std::sqrt(squared) / kLampReach_m), 0.0, 1.0);
    return static_cast<float>(lamp.strength * fading * falling * facing / (squared * squared) / kRaysPerLamp);
  }

  float unblocked(const SegmentPacket& segments, const Floats& strengths) const {
    Flags blocked{};
    scene_.find_blocked(segments, blocked);
    float sum = 0;
    for (int k = 0; k < kLanes; ++k) sum += blocked.at[k] != 0 ? 0.0f : strengths.at[k];
    return sum;
  }

  static void set(SegmentPacket& segments, int k, const Vec3& from, const Vec3& reach) {
    segments.from_x.at[k] = static_cast<float>(from.x());
    segments.from_y.at[k] = static_cast<float>(from.y());
    segments.from_z.at[k] = static_cast<float>(from.z());
    segments.x.at[k] = static_cast<float>(reach.x());
    segments.y.at[k] = static_cast<float>(reach.y());
    segments.z.at[k] = static_cast<float>(reach.z());
    segments.asked.at[k] = -1;
  }

  const RayScene& scene_;
  std::vector<LampPlace> lamps_;
  std::uint64_t seed_;
};

std::vector<PanelSide> sides_of(std::span<const Panel> panels, std::span<ShadedSurface> surfaces) {
  std::vector<PanelSide> sides;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Vec3 outside = panels[i].outside();
    sides.push_back({&panels[i], &surfaces[i].outside, outside});
    if (panels[i].is_two_sided) sides.push_back({&panels[i], &surfaces[i].inside, -outside});
  }
  return sides;
}

/// Lays out all maps with texels of a size. @return how many texels they have
std::size_t lay_out(std::span<const PanelSide> sides, double texel_m) {
  std::size_t next = 0;
  for (const PanelSide& side : sides) {
    LightMap& map = *side.map;
    const double along_m = side.panel->along.norm(), up_m = side.panel->up.norm();
    map.columns = 2 + static_cast<int>(along_m / texel_m);
    map.rows = 2 + static_cast<int>(up_m / texel_m);
    map.first_texel = static_cast<int>(next);
    next += static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  }
  return next;
}

/// From the pattern coordinates to the map's: both are linear along the panel's edges.
void connect(const Panel& panel, const SceneFrame& frame, const ShadedSurface& surface, LightMap& map) {
  const Eigen::Vector3f corner = frame(panel.corner).cast<float>();
  const Eigen::Vector3f along = panel.along.cast<float>(), up = panel.up.cast<float>();
  const auto connect_one = [&](const std::array<float, 4>& pattern, const Eigen::Vector3f& edge, int count,
                               float& per_unit, float& at_0) {
    const Eigen::Vector3f gradient(pattern[0], pattern[1], pattern[2]);
    const float begin = gradient.dot(corner) + pattern[3], length = gradient.dot(edge);
    per_unit = static_cast<float>(count - 1) / length;
    at_0 = -begin * per_unit;
  };
  connect_one(surface.u, along, map.columns, map.columns_per_u, map.column_at_0);
  connect_one(surface.v, up, map.rows, map.rows_per_v, map.row_at_0);
}

/// Places inside something take the light of their lit neighbours, so that no darkness leaks out along edges.
void fill_buried(const LightMap& map, std::vector<Light>& lights) {
  const auto at = [&](int column, int row) -> Light& {
    return lights[static_cast<std::size_t>(map.first_texel + row * map.columns + column)];
  };
  const auto is_buried = [](const Light& light) {
    return light.from_everywhere < kBuried && light.from_lamps <= 0;
  };
  for (int round = 0; round < 2; ++round) {
    std::vector<std::pair<Light*, Light>> filled;
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) {
        if (!is_buried(at(column, row))) continue;
        Light sum;
        float count = 0;
        for (int y = std::max(0, row - 1); y <= std::min(map.rows - 1, row + 1); ++y) {
          for (int x = std::max(0, column - 1); x <= std::min(map.columns - 1, column + 1); ++x) {
            if (is_buried(at(x, y))) continue;
            sum.from_everywhere += at(x, y).from_everywhere;
            sum.from_lamps += at(x, y).from_lamps;
            ++count;
          }
        }
        if (count > 0)
          filled.push_back({&at(column, row), {sum.from_everywhere / count, sum.from_lamps / count}});
      }
    }
    for (auto& [light, value] : filled) *light = value;
  }
}

/// The lamps' light on a well-lit floor: of fifty lit places one has more.
float well_lit(const LightMap& floor, const std::vector<Light>& lights) {
  std::vector<float> lit;
  for (int i = 0; i < floor.columns * floor.rows; ++i) {
    const float light = lights[static_cast<std::size_t>(floor.first_texel + i)].from_lamps;
    if (light > 0) lit.push_back(light);
  }
  if (lit.empty()) return 1;
  const auto brightest = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() * 49 / 50);
  std::nth_element(lit.begin(), brightest, lit.end());
  return *brightest;
}

}  // namespace

std::uint32_t light_texel(float from_everywhere, float from_lamps) {
  const auto share = [](float light) {
    return static_cast<std::uint32_t>(
        std::lround(65535 * std::clamp(light / LightTexels::kLightMax, 0.0f, 1.0f)));
  };
  return share(from_everywhere) | share(from_lamps) << 16;
}

LightTexels bake_light(const World& world, std::span<const Panel> panels, const RayScene& scene,
                       const SceneFrame& frame, std::span<ShadedSurface> surfaces) {
  const std::vector<PanelSide> sides = sides_of(panels, surfaces);
  double texel_m = kTexel_m;
  std::size_t count = lay_out(sides, texel_m);
  while (count > kTexelsMax) count = lay_out(sides, texel_m *= 1.5);

  std::vector<Light> lights(count);
  const Baker baker(world, scene, frame);
  tbb::parallel_for(std::size_t{0}, sides.size(), [&](std::size_t i) {
    const PanelSide& side = sides[i];
    const LightMap& map = *side.map;
    const Vec3 step_along = side.panel->along / map.columns, step_up = side.panel->up / map.rows;
    const Vec3 corner = frame(side.panel->corner) + kAboveSurface_m * side.normal;
    tbb::parallel_for(0, map.rows, [&](int row) {
      for (int column = 0; column < map.columns; ++column) {
        const Vec3 p = corner + inset(column, map.columns, side.panel->along.norm()) * side.panel->along +
                       inset(row, map.rows, side.panel->up.norm()) * side.panel->up;
        const auto texel = static_cast<std::size_t>(map.first_texel + row * map.columns + column);
        lights[texel] = baker.at(side, p, step_along, step_up, texel);
      }
    });
    fill_buried(map, lights);
  });

  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    connect(panels[i], frame, surfaces[i], surfaces[i].outside);
    if (panels[i].is_two_sided) {
      connect(panels[i], frame, surfaces[i], surfaces[i].inside);
    } else {
      surfaces[i].inside = surfaces[i].outside;
    }
  }
  const float unit_light = well_lit(surfaces.front().outside, lights);
  LightTexels baked;
  baked.texels.reserve(count);
  for (const Light& light : lights) {
    baked.texels.push_back(light_texel(light.from_everywhere, light.from_lamps / unit_light));
  }
  return baked;
}

}  // namespace aisle
