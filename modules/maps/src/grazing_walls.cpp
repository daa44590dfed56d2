#include "aisle/maps/grazing_walls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kGapMax_m = 0.25;     // longest gap in a wall, between two hit cells
constexpr double kHitShareMin = 0.4;   // of the cells over which a wall is extended
constexpr double kLeastMore_m = 0.1;   // a shorter extension is blur of the wall's end
constexpr double kLeastWall_m = 0.3;   // a shorter row of cells is no wall
constexpr double kExplained = 1.5;     // a hit within this many cells of a wall belongs to it
constexpr double kNearby_m = 1;        // walls within this of a row give it a direction
constexpr int kFreeBesideCells = 2;    // free floor is looked for this far from a row ...
constexpr double kFreeShareMin = 0.5;  // ... and must lie beside this share of it

/// Hit cells on a line, from a point onwards.
struct Run {
  int steps = 0;  ///< of one cell, up to the last hit
  int hit = 0;
  double across_m = 0;  ///< sum of their offsets to the left of the line
};

/// A possible direction of a wall.
struct Direction {
  Vec2 along;
  bool is_orthogonal = false;
};

class GrazingWalls {
 public:
  GrazingWalls(WallMap& map, const FloorGrid& floor) : walls_(map.walls), floor_(floor) {
    for (std::size_t i = 0; i < walls_.size(); ++i) note(i);
  }

  void extend(std::size_t wall) {
    Wall& extended = walls_[wall];
    if (extended.segment.length() == 0) return;
    const Vec2 along = (extended.segment.end - extended.segment.start).normalized();
    const double after_m = goes_on_m(extended.segment.end, along);
    const double before_m = goes_on_m(extended.segment.start, -along);
    if (after_m > 0) {
      extended.segment.end += after_m * along;
      extended.end = WallEnd::kUnknown;
    }
    if (before_m > 0) {
      extended.segment.start -= before_m * along;
      extended.start = WallEnd::kUnknown;
    }
    if (after_m > 0 || before_m > 0) note(wall);
  }

  /// Adds the longest new wall, if any, that a hit cell belongs to.
  void add(FloorCell cell) {
    const Vec2 p_map = floor_.centre(cell);
    if (floor_.at(cell) != Floor::kOccupied || is_explained(p_map)) return;
    std::optional<Wall> longest;
    for (const Direction& direction : directions_near(p_map)) {
      const auto wall = wall_through(p_map, direction);
      if (wall && (!longest || wall->segment.length() > longest->segment.length())) longest = wall;
    }
    if (!longest) return;
    walls_.push_back(*longest);
    note(walls_.size() - 1);
  }

 private:
  void note(std::size_t wall) { index_.add(walls_[wall].segment, static_cast<int>(wall)); }

  double goes_on_m(const Vec2& p_map_end, const Vec2& along) {
    const Run run = run_from(p_map_end, along);
    const double length_m = run.steps * floor_.cell_m();
    return length_m >= kLeastMore_m && run.hit >= kHitShareMin * run.steps ? length_m : 0;
  }

  Run run_from(const Vec2& p_map, const Vec2& along) {
    const double step_m = floor_.cell_m();
    Run run;
    for (int step = 1; (step - run.steps) * step_m <= kGapMax_m; ++step) {
      const auto across_m = hit_across_m(p_map + (step - 0.5) * step_m * along, left_normal(along));
      if (!across_m) continue;
      run.steps = step;
      ++run.hit;
      run.across_m += *across_m;
    }
    return run;
  }

  /// Offset from the line of a cell near this point that was hit and that no wall explains; one cell to
  /// either side counts, as cells are coarse.
  std::optional<double> hit_across_m(const Vec2& p_map, const Vec2& across) {
    for (const int beside : {0, -1, 1}) {
      const FloorCell cell = floor_.cell_at(Vec2(p_map + beside * floor_.cell_m() * across));
      const Vec2 p_map_cell = floor_.centre(cell);
      if (floor_.at(cell) == Floor::kOccupied && !is_explained(p_map_cell))
        return (p_map_cell - p_map).dot(across);
    }
    return std::nullopt;
  }

  bool is_explained(const Vec2& p_map) {
    const double near_m = kExplained * floor_.cell_m();
    index_.query(p_map, p_map, near_m, near_);
    return std::any_of(near_.begin(), near_.end(), [&](int wall) {
      return walls_[static_cast<std::size_t>(wall)].segment.distance(p_map) < near_m;
    });
  }

  /// Both axes, and parallel and perpendicular to the oblique walls nearby.
  std::vector<Direction> directions_near(const Vec2& p_map) {
    std::vector<Direction> directions{{Vec2::UnitX(), true}, {Vec2::UnitY(), true}};
    index_.query(p_map, p_map, kNearby_m, near_);
    for (const int i : near_) {
      const Wall& wall = walls_[static_cast<std::size_t>(i)];
      const bool is_nearby = wall.segment.length() > 0 && wall.segment.distance(p_map) < kNearby_m;
      if (wall.is_orthogonal || !is_nearby) continue;
      const Vec2 along = (wall.segment.end - wall.segment.start).normalized();
      directions.push_back({along});
      directions.push_back({left_normal(along)});
    }
    return directions;
  }

  std::optional<Wall> wall_through(const Vec2& p_map, const Direction& direction) {
    const Vec2& along = direction.along;
    const double cell_m = floor_.cell_m();
    const Vec2 p_map_edge = p_map - cell_m / 2 * along;
    const Run after = run_from(p_map_edge, along), before = run_from(p_map_edge, -along);
    const int steps = after.steps + before.steps, hit = after.hit + before.hit;
    if (steps * cell_m < kLeastWall_m || hit < kHitShareMin * steps) return std::nullopt;
    const double across_m = (after.across_m - before.across_m) / hit;
    const Vec2 p_map_line = p_map_edge + across_m * left_normal(along);
    Wall wall{
        .segment = {p_map_line - before.steps * cell_m * along, p_map_line + after.steps * cell_m * along},
        .is_orthogonal = direction.is_orthogonal,
        .sightings = 1,
        .sigma_m = cell_m / std::sqrt(12.0)};
    if (is_free_to_the_left(wall.segment)) return wall;
    wall.segment = wall.segment.reversed();
    return is_free_to_the_left(wall.segment) ? std::optional(wall) : std::nullopt;
  }

  bool is_free_to_the_left(const Segment2& segment) const {
    const double cell_m = floor_.cell_m();
    const Vec2 along = (segment.end - segment.start).normalized();
    const int steps = static_cast<int>(std::lround(segment.length() / cell_m));
    int free = 0;
    for (int step = 0; step < steps; ++step) {
      const Vec2 p_map =
          segment.start + cell_m * ((step + 0.5) * along + kFreeBesideCells * left_normal(along));
      free += floor_.at(p_map) == Floor::kFree ? 1 : 0;
    }
    return free >= kFreeShareMin * steps;
  }

  std::vector<Wall>& walls_;
  const FloorGrid& floor_;
  CellIndex index_;
  std::vector<int> near_;
};

}  // namespace

void draw_grazing_walls(WallMap& map, const FloorGrid& floor) {
  GrazingWalls grazing(map, floor);
  const std::size_t count = map.walls.size();
  for (std::size_t wall = 0; wall < count; ++wall) grazing.extend(wall);
  const FloorBox& known = floor.known();
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) grazing.add({x, y});
  }
}

}  // namespace aisle
