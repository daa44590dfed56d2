#pragma once
/// Lines on the floor drawn by a person: a vehicle never crosses them, whatever it sees there.

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct Barrier {
  enum class Kind {
    kKeepOut,  ///< a person wants the vehicle to stay out
    kGlass     ///< a glass pane, which sensors do not see
  };

  Kind kind = Kind::kKeepOut;
  Segment2 segment;  ///< in `map`; its direction means nothing
};

/// "keep-out line", "glass"
const char* words_for(Barrier::Kind kind);

/// Whether the segment meets or lies inside the outline of a vehicle with base_link at the origin of the
/// segment's frame.
bool meets(const Footprint& footprint, const Segment2& segment);

/// The first barrier that a vehicle at this pose meets; nullptr: none.
const Barrier* barrier_met(std::span<const Barrier> barriers, const Footprint& footprint,
                           const Pose2& T_map_vehicle);

/// Every cell that the segment passes through, row by row from below; cells beyond the floor's reach are left
/// out.
/// @param cell_m  > 0
std::vector<FloorCell> cells_under(const Segment2& segment, double cell_m);

}  // namespace aisle
