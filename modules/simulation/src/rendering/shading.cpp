#include "rendering/shading.hpp"

#include <bit>
#include <cmath>

#include "rendering/kernel.hpp"
#include "rendering/light_baking.hpp"

namespace aisle {
namespace {

constexpr int kTextureStride = 2 * Texture::kSide;

/// Where the rays meet the surface, in pattern coordinates, and how much of the pattern a pixel sees.
struct PatternPlaces {
  Floats u, v, width_u, width_v;
};

AISLE_INLINE float dot(const std::array<float, 3>& a, float x, float y, float z) {
  return a[0] * x + a[1] * y + a[2] * z;
}

AISLE_INLINE float dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

AISLE_INLINE std::array<float, 3> gradient(const std::array<float, 4>& coordinate) {
  return {coordinate[0], coordinate[1], coordinate[2]};
}

/// Clamps to [low, high], NaN included.
AISLE_INLINE float bounded(float value, float low, float high) {
  value = value > low ? value : low;
  return value < high ? value : high;
}

/// How much a coordinate changes over a pixel, where it changes by `by_column` and `by_row` to the next ones.
AISLE_INLINE float footprint(float by_column, float by_row) {
  constexpr float kLeast = 1e-5f, kMost = 1e5f;
  return bounded(std::sqrt(by_column * by_column + by_row * by_row), kLeast, kMost);
}

AISLE_INLINE void find_places(const ShadedSurface& surface, const RayPacket& rays, const Flags& on,
                              PatternPlaces& places) {
  const std::array<float, 3> normal = surface.normal, u = gradient(surface.u), v = gradient(surface.v);
  const float height = surface.plane - dot(normal, rays.origin);
  const float u_origin = dot(u, rays.origin) + surface.u[3], v_origin = dot(v, rays.origin) + surface.v[3];
  const float normal_column = dot(normal, rays.by_column), normal_row = dot(normal, rays.by_row);
  const float u_column = dot(u, rays.by_column), u_row = dot(u, rays.by_row);
  const float v_column = dot(v, rays.by_column), v_row = dot(v, rays.by_row);
  for (int k = 0; k < kLanes; ++k) {
    const float x = rays.x.at[k], y = rays.y.at[k], z = rays.z.at[k];
    const float per_falling = 1 / dot(normal, x, y, z);
    const float length = on.at[k] != 0 ? height * per_falling : 0;
    const float along_u = dot(u, x, y, z), along_v = dot(v, x, y, z);
    const float slope_u = along_u * per_falling, slope_v = along_v * per_falling;
    places.u.at[k] = u_origin + (on.at[k] != 0 ? length * along_u : 0);
    places.v.at[k] = v_origin + (on.at[k] != 0 ? length * along_v : 0);
    places.width_u.at[k] =
        footprint(length * (u_column - slope_u * normal_column), length * (u_row - slope_u * normal_row));
    places.width_v.at[k] =
        footprint(length * (v_column - slope_v * normal_column), length * (v_row - slope_v * normal_row));
  }
}

AISLE_INLINE float interpolated(float a, float b, float c, float d, float x, float y) {
  return (a + (b - a) * x) * (1 - y) + (c + (d - c) * x) * y;
}

/// One axis of a texture look-up.
struct TexelAxis {
  int index;    ///< in the store
  float share;  ///< of the distance to the next texel
};

AISLE_INLINE TexelAxis texel_axis(float texels, float footprint_texels) {
  constexpr float kSqrt2 = 1.41421356f;
  constexpr int kExponent = 23, kBias = 127;
  const float width = bounded(footprint_texels * kSqrt2, 1, 1 << (Texture::kLevels - 1));
  const int level = (std::bit_cast<std::int32_t>(width) >> kExponent) - kBias;
  const float scale = std::bit_cast<float>((kBias - level) << kExponent);
  const float place = texels * scale - 0.5f, whole = std::floor(place);
  const int side = Texture::kSide >> level;
  return {kTextureStride - (kTextureStride >> level) + (static_cast<int>(whole) & (side - 1)), place - whole};
}

/// Adds the layer's share of darker or brighter.
AISLE_INLINE void add_layer(const PatternLayer& layer, const std::uint32_t* store,
                            const PatternPlaces& places, Floats& shade) {
  constexpr float kPerByte = 2.0f / 255;
  for (int k = 0; k < kLanes; ++k) {
    const TexelAxis x =
        texel_axis(places.u.at[k] * layer.texels_per_u, places.width_u.at[k] * layer.texels_per_u);
    const TexelAxis y =
        texel_axis(places.v.at[k] * layer.texels_per_v, places.width_v.at[k] * layer.texels_per_v);
    const auto texels = static_cast<std::int32_t>(store[y.index * kTextureStride + x.index]);
    const float value = interpolated(
        static_cast<float>(texels & 255), static_cast<float>((texels >> 8) & 255),
        static_cast<float>((texels >> 16) & 255), static_cast<float>((texels >> 24) & 255), x.share, y.share);
    shade.at[k] += layer.contrast * (value * kPerByte - 1);
  }
}

/// How much joint there is from 0 to x, in periods.
AISLE_INLINE float joint_before(float x, float share) {
  const float whole = std::floor(x), rest = x - whole;
  return whole * share + (rest < share ? rest : share);
}

/// The share of a pixel's footprint that is joint.
AISLE_INLINE float joint_share(float place, float width, float share) {
  const float begin = place + share / 2 - width / 2;
  return (joint_before(begin + width, share) - joint_before(begin, share)) / width;
}

/// A value from -1 to 1 for each tile.
AISLE_INLINE float tile_value(float column, float row) {
  std::uint32_t h = static_cast<std::uint32_t>(static_cast<std::int32_t>(column)) * 0x9e3779b1u +
                    static_cast<std::uint32_t>(static_cast<std::int32_t>(row)) * 0x85ebca77u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<float>(static_cast<std::int32_t>(h >> 16)) * (2.0f / 65535) - 1;
}

AISLE_INLINE void lay_tiles(const Joints& joints, const PatternPlaces& places, Floats& shade) {
  const float per_u = 1 / joints.period_u, per_v = 1 / joints.period_v;
  const float share_u = joints.width * per_u, share_v = joints.width * per_v;
  for (int k = 0; k < kLanes; ++k) {
    const float u = places.u.at[k] * per_u, v = places.v.at[k] * per_v;
    const float width_u = places.width_u.at[k] * per_u, width_v = places.width_v.at[k] * per_v;
    const float widest = width_u > width_v ? width_u : width_v;
    const float fading = 1 - widest > 0 ? 1 - widest : 0;
    const float free = (1 - joint_share(u, width_u, share_u)) * (1 - joint_share(v, width_v, share_v));
    const float tile = joints.variation * fading * tile_value(std::floor(u), std::floor(v));
    shade.at[k] = (shade.at[k] + tile) * (1 - joints.darkness * (1 - free));
  }
}

/// The integral of a wave that is +1 in even and -1 in odd squares.
AISLE_INLINE float squares_before(float x) {
  const float phase = x - 2 * std::floor(x / 2);
  return phase < 1 ? phase : 2 - phase;
}

/// How much of a footprint along one axis lies within the squares, and how much more in even than in odd
/// ones.
struct SquareShares {
  float within, even_more;
};

AISLE_INLINE SquareShares square_shares(float place, float width, float squares) {
  const float begin = bounded(place - width / 2, 1, squares - 1) - 1,
              end = bounded(place + width / 2, 1, squares - 1) - 1;
  return {(end - begin) / width, (squares_before(end) - squares_before(begin)) / width};
}

/// Black squares inside a white margin of one square; the one at the upper left is black.
AISLE_INLINE void lay_chessboard(const Material& material, const PatternPlaces& places, Floats& shade) {
  constexpr float kBlack = 0.05f;
  const float columns = material.chessboard_columns, rows = material.chessboard_rows;
  for (int k = 0; k < kLanes; ++k) {
    const SquareShares u = square_shares(places.u.at[k] * columns, places.width_u.at[k] * columns, columns);
    const SquareShares v = square_shares(places.v.at[k] * rows, places.width_v.at[k] * rows, rows);
    const float black = (u.within * v.within + u.even_more * v.even_more) / 2;
    shade.at[k] *= 1 - (1 - kBlack) * black;
  }
}

/// The four texels of a light map around a place, and where it is between them.
struct LightPlaces {
  std::int32_t left_above[kLanes], right_above[kLanes], left_below[kLanes], right_below[kLanes];
  Floats x, y;
};

/// Numbers of the texels first, the texels themselves after that: only so both loops become vector
/// instructions.
AISLE_INLINE void find_light(const LightMap& map, const std::uint32_t* texels, const PatternPlaces& places,
                             LightPlaces& light) {
  const int last_column = map.columns - 1, last_row = map.rows - 1;
  for (int k = 0; k < kLanes; ++k) {
    const float x =
        bounded(places.u.at[k] * map.columns_per_u + map.column_at_0, 0, static_cast<float>(last_column));
    const float y = bounded(places.v.at[k] * map.rows_per_v + map.row_at_0, 0, static_cast<float>(last_row));
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const int right = column < last_column ? 1 : 0, below = row < last_row ? map.columns : 0;
    light.left_above[k] = map.first_texel + row * map.columns + column;
    light.right_above[k] = light.left_above[k] + right;
    light.left_below[k] = light.left_above[k] + below;
    light.right_below[k] = light.right_above[k] + below;
    light.x.at[k] = x - static_cast<float>(column);
    light.y.at[k] = y - static_cast<float>(row);
  }
  for (auto* corner : {&light.left_above, &light.right_above, &light.left_below, &light.right_below}) {
    for (std::int32_t& number : *corner) number = static_cast<std::int32_t>(texels[number]);
  }
}

AISLE_INLINE void light_up(const LightMap& map, const std::uint32_t* texels, const LightLevels& levels,
                           const PatternPlaces& places, Floats& radiance) {
  constexpr float kPerStep = LightTexels::kLightMax / 65535;
  const float everywhere = levels.from_everywhere * kPerStep, lamps = levels.from_lamps * kPerStep;
  LightPlaces light;
  find_light(map, texels, places, light);
  const auto both = [&](std::int32_t texel) {
    return everywhere * static_cast<float>(texel & 0xffff) +
           lamps * static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(texel) >> 16));
  };
  for (int k = 0; k < kLanes; ++k) {
    radiance.at[k] *=
        interpolated(both(light.left_above[k]), both(light.right_above[k]), both(light.left_below[k]),
                     both(light.right_below[k]), light.x.at[k], light.y.at[k]);
  }
}

}  // namespace

AISLE_KERNEL
void shade(const ShadedSurface& surface, const ShadingTables& tables, const LightLevels& levels,
           const RayPacket& rays, const Flags& on_surface, Floats& radiance) {
  const Material& material = tables.materials[static_cast<std::size_t>(surface.material)];
  PatternPlaces places;
  find_places(surface, rays, on_surface, places);
  for (int k = 0; k < kLanes; ++k) radiance.at[k] = 1;
  for (const PatternLayer* layer : {&material.detail, &material.unevenness}) {
    if (layer->contrast == 0) continue;
    add_layer(*layer, tables.textures[static_cast<std::size_t>(layer->texture)].store(), places, radiance);
  }
  if (material.joints.period_u > 0) lay_tiles(material.joints, places, radiance);
  if (material.chessboard_columns > 0) lay_chessboard(material, places, radiance);

  const bool is_outside = dot(surface.normal, rays.origin) > surface.plane;
  light_up(is_outside ? surface.outside : surface.inside, tables.light_texels, levels, places, radiance);
  const float glow = levels.glow * material.glow;
  for (int k = 0; k < kLanes; ++k) {
    const float back = material.brightness * radiance.at[k];
    radiance.at[k] = (back > 0 ? back : 0) + glow;
  }
}

AISLE_KERNEL
void find_mirrored(float gloss, const RayPacket& rays, Floats& mirrored) {
  constexpr float kFacing = 0.04f;  // of what comes from straight above: as wax, varnish and vinyl do
  for (int k = 0; k < kLanes; ++k) {
    const float x = rays.x.at[k], y = rays.y.at[k], z = rays.z.at[k];
    const float grazing = 1 - std::abs(z) / std::sqrt(x * x + y * y + z * z);
    const float squared = grazing * grazing;
    mirrored.at[k] = gloss * (kFacing + (1 - kFacing) * squared * squared * grazing);
  }
}

AISLE_KERNEL
bool shade_stripe(const ShadedSurface& surface, const LaserPlane& laser, const RayPacket& rays,
                  const Flags& on_surface, Floats& stripe, SegmentPacket& segments) {
  constexpr float kBeam_m = 0.0018f;          ///< standard deviation of the light plane's profile
  constexpr float kPixel = 0.5f;              ///< standard deviation of what a pixel sees [px]
  constexpr float kProfileRoot = 2.6457513f;  ///< half width of (1 - x^2)^2 over its standard deviation
  constexpr float kNearest_m = 0.2f;
  const float height = laser.projector[2];
  const std::array<float, 3> normal = surface.normal;
  const float above = surface.plane - dot(normal, rays.origin);
  const float projector_above = dot(normal, laser.projector) - surface.plane;
  if (above * projector_above >= 0) return false;  // the lit side is not the one that is seen
  const float normal_column = dot(normal, rays.by_column), normal_row = dot(normal, rays.by_row);
  Floats length, half_width, inside;
  std::int32_t any = 0;
  for (int k = 0; k < kLanes; ++k) {
    const float x = rays.x.at[k], y = rays.y.at[k], z = rays.z.at[k];
    const float per_falling = 1 / dot(normal, x, y, z);
    length.at[k] = above * per_falling;
    const float z_column = length.at[k] * (rays.by_column[2] - z * normal_column * per_falling),
                z_row = length.at[k] * (rays.by_row[2] - z * normal_row * per_falling);
    const float seen = kPixel * footprint(z_column, z_row);
    half_width.at[k] = kProfileRoot * std::sqrt(kBeam_m * kBeam_m + seen * seen);
    const float place = (rays.origin[2] + length.at[k] * z - height) / half_width.at[k];
    inside.at[k] = 1 - place * place;
    any |= (on_surface.at[k] != 0) & (inside.at[k] > 0) ? 1 : 0;
  }
  if (any == 0) return false;
  any = 0;
  for (int k = 0; k < kLanes; ++k) {
    const float px = rays.origin[0] + length.at[k] * rays.x.at[k],
                py = rays.origin[1] + length.at[k] * rays.y.at[k],
                pz = rays.origin[2] + length.at[k] * rays.z.at[k];
    const float to_x = laser.projector[0] - px, to_y = laser.projector[1] - py, to_z = height - pz;
    const float distance = std::sqrt(to_x * to_x + to_y * to_y) + kNearest_m;
    const float is_ahead = -(to_x * laser.ahead[0] + to_y * laser.ahead[1]);
    const float facing = std::abs(normal[0] * to_x + normal[1] * to_y) / distance;
    const bool is_lit = (on_surface.at[k] != 0) & (inside.at[k] > 0) & (is_ahead > 0);
    const float light = laser.strength * facing / distance * inside.at[k] * inside.at[k] *
                        (kProfileRoot * kBeam_m / half_width.at[k]);
    stripe.at[k] = is_lit ? light : 0;
    segments.from_x.at[k] = px;
    segments.from_y.at[k] = py;
    segments.from_z.at[k] = pz;
    segments.x.at[k] = to_x;
    segments.y.at[k] = to_y;
    segments.z.at[k] = to_z;
    segments.asked.at[k] = is_lit ? -1 : 0;
    any |= segments.asked.at[k];
  }
  return any != 0;
}

}  // namespace aisle
