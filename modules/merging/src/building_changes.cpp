#include "aisle/merging/building_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "aisle/merging/moved_building.hpp"
#include "floor_change.hpp"
#include "wall_fates.hpp"

namespace aisle {
namespace {

constexpr double kMoveMax_m = 1;       // farther away it is another wall
constexpr double kParallel = 0.97;     // cosine of 14 degrees
constexpr double kSharedLength = 0.5;  // of the shorter of two pieces that are one wall, moved
constexpr double kDoorMin_m = 0.55, kDoorMax_m = 1.4;
constexpr double kJamb_m = 0.4;     // from a door's ends to the wall that it is in, along it ...
constexpr double kReveal_m = 0.35;  // ... and across

/// Walls of one map in pieces of one fate each.
void add_pieces(const WallMap& walls, const MapPattern& other, bool is_of_new,
                std::vector<ChangedWall>& pieces) {
  for (const Wall& wall : walls.walls) {
    if (wall.segment.length() < kFateMin_m) continue;
    const auto fates = fates_along(wall, other, is_of_new ? WallChange::kNew : WallChange::kGone);
    const Vec2 step = (wall.segment.end - wall.segment.start) / static_cast<double>(fates.size());
    for (std::size_t first = 0; first < fates.size();) {
      std::size_t end = first;
      while (end < fates.size() && fates[end] == fates[first]) ++end;
      const Vec2 from = wall.segment.start + static_cast<double>(first) * step;
      const Vec2 to = wall.segment.start + static_cast<double>(end) * step;
      pieces.push_back({{from, to}, fates[first], is_of_new});
      first = end;
    }
  }
}

Vec2 along_of(const Segment2& segment) {
  return (segment.end - segment.start).normalized();
}

Interval span_on(const Segment2& line, const Segment2& other) {
  const Vec2 along = along_of(line);
  const double a = along.dot(other.start - line.start), b = along.dot(other.end - line.start);
  return {std::min(a, b), std::max(a, b)};
}

/// How far `to` lies from `from`, across it, if it may be the same wall moved.
std::optional<double> move_between(const Segment2& from, const Segment2& to) {
  const Vec2 along = along_of(from);
  if (along.dot(along_of(to)) < kParallel) return std::nullopt;
  const double moved_m = left_normal(along).dot(to.midpoint() - from.midpoint());
  if (std::abs(moved_m) > kMoveMax_m) return std::nullopt;
  const double shared_m = Interval{0, from.length()}.overlap(span_on(from, to));
  if (shared_m < kSharedLength * std::min(from.length(), to.length())) return std::nullopt;
  return moved_m;
}

/// A piece of the new map that stands on free floor of the old one, beside a piece of the old one that is no
/// longer there (or that nobody can see now), is that piece, moved; and the other way round.
void pair_moved(std::vector<ChangedWall>& pieces) {
  const auto is_open = [](const ChangedWall& piece) {
    return piece.change != WallChange::kKept && piece.change != WallChange::kMoved;
  };
  for (ChangedWall& now : pieces) {
    if (!now.is_of_new || !is_open(now)) continue;
    ChangedWall* nearest = nullptr;
    double moved_m = kMoveMax_m;
    for (ChangedWall& before : pieces) {
      if (before.is_of_new || !is_open(before)) continue;
      if (now.change == WallChange::kNotCompared && before.change == WallChange::kNotCompared) continue;
      const auto move_m = move_between(before.segment, now.segment);
      if (!move_m || std::abs(*move_m) > std::abs(moved_m)) continue;
      nearest = &before;
      moved_m = *move_m;
    }
    if (nearest == nullptr) continue;
    now.change = nearest->change = WallChange::kMoved;
    now.moved_m = nearest->moved_m = moved_m;
  }
}

/// Whether a wall that both maps have goes on from this end of an opening, within the opening's wall.
bool has_jamb(const std::vector<ChangedWall>& pieces, const Vec2& p_end, const Vec2& outwards) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const ChangedWall& piece) {
    if (piece.change != WallChange::kKept || std::abs(along_of(piece.segment).dot(outwards)) < kParallel)
      return false;
    for (const Vec2& p : {piece.segment.start, piece.segment.end}) {
      const Vec2 off = p - p_end;
      const bool is_near =
          std::abs(off.dot(outwards)) < kJamb_m && std::abs(cross(off, outwards)) < kReveal_m;
      const bool goes_on = (piece.segment.midpoint() - p).dot(outwards) > 0;
      if (is_near && goes_on) return true;
    }
    return false;
  });
}

bool is_same_opening(const Segment2& a, const Segment2& b) {
  return (a.midpoint() - b.midpoint()).norm() < kJamb_m;
}

/// Pieces as wide as a door that stand in a wall, in one of the maps only. The two faces of one leaf are one
/// door.
std::vector<DoorChange> doors_among(const std::vector<ChangedWall>& pieces) {
  std::vector<DoorChange> doors;
  for (const ChangedWall& piece : pieces) {
    const bool is_shut = piece.change == WallChange::kNew, is_open = piece.change == WallChange::kGone;
    const double width_m = piece.segment.length();
    if ((!is_shut && !is_open) || width_m < kDoorMin_m || width_m > kDoorMax_m) continue;
    const Vec2 along = along_of(piece.segment);
    if (!has_jamb(pieces, piece.segment.end, along) || !has_jamb(pieces, piece.segment.start, -along))
      continue;
    if (std::any_of(doors.begin(), doors.end(),
                    [&](const DoorChange& door) { return is_same_opening(door.opening, piece.segment); }))
      continue;
    doors.push_back({piece.segment, is_open});
  }
  return doors;
}

FloorChanges floor_changes(const FloorGrid& old_floor, const FloorGrid& new_floor) {
  FloorChanges changes{.cell_m = old_floor.cell_m(), .box = old_floor.known()};
  changes.box.include_box(new_floor.known());
  for (int y = changes.box.low.y; y < changes.box.end.y; ++y) {
    for (int x = changes.box.low.x; x < changes.box.end.x; ++x)
      changes.cells.push_back(change_of_cell(old_floor, new_floor, {x, y}));
  }
  return changes;
}

}  // namespace

FloorChange FloorChanges::at(FloorCell cell) const {
  const auto width = static_cast<std::size_t>(box.end.x - box.low.x);
  return cells[static_cast<std::size_t>(cell.y - box.low.y) * width +
               static_cast<std::size_t>(cell.x - box.low.x)];
}

double FloorChanges::area_m2(FloorChange change) const {
  return static_cast<double>(std::count(cells.begin(), cells.end(), change)) * cell_m * cell_m;
}

double BuildingChanges::length_m(WallChange change) const {
  const bool is_twofold = change == WallChange::kKept || change == WallChange::kMoved;
  return std::accumulate(walls.begin(), walls.end(), 0.0, [&](double sum_m, const ChangedWall& wall) {
    const bool counts = wall.change == change && (!is_twofold || wall.is_of_new);
    return counts ? sum_m + wall.segment.length() : sum_m;
  });
}

BuildingChanges changes_between(const Building& old_map, const Building& new_map, const Pose2& T_old_new) {
  if (!old_map.floor || !new_map.floor)
    throw std::invalid_argument("maps without a floor do not say what they have not seen");
  const double cell_m = std::max(old_map.floor->cell_m(), new_map.floor->cell_m());
  const Building placed = moved_building(new_map, T_old_new, cell_m);
  const MapPattern before(old_map), now(placed);
  BuildingChanges changes;
  add_pieces(old_map.walls, now, false, changes.walls);
  add_pieces(placed.walls, before, true, changes.walls);
  pair_moved(changes.walls);
  changes.doors = doors_among(changes.walls);
  changes.floor = floor_changes(moved_floor(*old_map.floor, {}, cell_m), *placed.floor);
  return changes;
}

}  // namespace aisle
