#pragma once

namespace aisle {

/// The frame of aisle's maps, as ROS calls it.
inline constexpr const char* kMapFrameId = "map";

}  // namespace aisle
