#pragma once
/// Lines on the floor that a person drew: a vehicle never crosses them, whatever it sees there.

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct Barrier {
  enum class Kind {
    kKeepOut,  ///< somebody requests it
    kGlass     ///< a pane stands there, which sensors do not see
  };

  Kind kind = Kind::kKeepOut;
  Segment2 segment;  ///< in `map`; its direction means nothing
};

/// "keep-out line", "glass"
const char* words_for(Barrier::Kind kind);

/// Whether the outline of a vehicle at base_link = the segment's frame, or what is within, meets the segment.
bool meets(const Footprint& footprint, const Segment2& segment);

/// The first barrier that a vehicle meets where it stands; null: none.
const Barrier* barrier_met(std::span<const Barrier> barriers, const Footprint& footprint,
                           const Pose2& T_map_vehicle);

/// Every cell that the segment passes, row by row from below; what lies beyond the floor's reach is left out.
/// @param cell_m  > 0
std::vector<FloorCell> cells_under(const Segment2& segment, double cell_m);

}  // namespace aisle
