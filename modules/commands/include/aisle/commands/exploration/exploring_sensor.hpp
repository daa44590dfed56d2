#pragma once

namespace aisle {

/// What shows a vehicle that explores its surroundings.
enum class ExploringSensor { kScanner, kMarkers };

}  // namespace aisle
