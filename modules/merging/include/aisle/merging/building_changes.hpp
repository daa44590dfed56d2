#pragma once
/// What has changed between two maps of one building.

#include <cstdint>
#include <vector>

#include "aisle/merging/map_pattern.hpp"

namespace aisle {

enum class WallChange {
  kKept,        ///< in both
  kNew,         ///< the old map had seen free floor there
  kGone,        ///< the new map has seen free floor there
  kMoved,       ///< gone from one place, new at another beside it
  kNotCompared  ///< only one of the two maps has seen the place
};

/// A piece of a wall with one fate. In the old map's frame.
struct ChangedWall {
  Segment2 segment;
  WallChange change = WallChange::kKept;
  bool is_of_new = false;  ///< as the new map shows it; else as the old one does
  double moved_m = 0;      ///< of what has moved: across itself, positive towards its free side
};

/// An opening in a wall, as wide as a door, that was shut or opened.
struct DoorChange {
  Segment2 opening;  ///< in the old map's frame
  bool is_open = false;
};

enum class FloorChange : std::uint8_t { kNotSeen, kSame, kWon, kLost, kOnlyOld, kOnlyNew };

/// The floor's cells, row by row from the lowest, each from the left. In the old map's frame.
struct FloorChanges {
  double cell_m = 0.05;
  FloorBox box;  ///< of cells as FloorGrid counts them
  std::vector<FloorChange> cells;

  FloorChange at(FloorCell cell) const;  ///< a cell of the box
  double area_m2(FloorChange change) const;
};

struct BuildingChanges {
  std::vector<ChangedWall> walls;
  std::vector<DoorChange> doors;
  FloorChanges floor;

  /// Of kept and moved walls, as the new map shows them.
  double length_m(WallChange change) const;
};

/// Compares two maps whose frames are known to each other. Walls that differ by less than MapPattern::kSame_m
/// are the same, pieces shorter than 0.35 m are not looked at, and floor that stands beside an equal cell of
/// the other map is no change: the maps themselves are no better.
/// @param old_map, new_map  both with a floor (std::invalid_argument)
BuildingChanges changes_between(const Building& old_map, const Building& new_map, const Pose2& T_old_new);

}  // namespace aisle
