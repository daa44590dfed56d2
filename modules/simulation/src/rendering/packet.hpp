#pragma once

#include <array>
#include <cstdint>

namespace aisle {

/// Rays are traced and shaded sixteen at a time: 4 x 4 neighbouring pixels, row by row.
inline constexpr int kLanes = 16;
inline constexpr int kPacketSide = 4;

struct alignas(64) Floats {
  float at[kLanes];
};
struct alignas(64) Flags {
  std::int32_t at[kLanes];  ///< -1: set
};

/// What rays hit first; kNoSurface: nothing.
inline constexpr std::uint32_t kNoSurface = 0xffffffff;
struct alignas(64) Hits {
  std::uint32_t at[kLanes];
};

/// Rays from one point, in the scene's frame.
struct RayPacket {
  Floats x, y, z;  ///< directions of any length
  std::array<float, 3> origin{};
  std::array<float, 3> by_column{}, by_row{};  ///< change of the direction from a pixel to the next
};

/// Segments between points, in the scene's frame, that may be blocked: shadow and occlusion rays.
struct SegmentPacket {
  Floats from_x, from_y, from_z;
  Floats x, y, z;  ///< to the other end
  Flags asked;     ///< lanes that are not set are ignored
};

}  // namespace aisle
