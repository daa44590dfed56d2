#pragma once

namespace aisle {

/// The sensor to explore with: a range scanner, or line lasers with a camera.
enum class ExploringSensor { kScanner, kMarkers };

}  // namespace aisle
