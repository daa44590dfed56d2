#include "aisle/maps/wall_extension.hpp"

#include <algorithm>
#include <vector>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kGapMax_m = 0.25;       // of a wall, between two cells that were struck
constexpr double kStruckShareMin = 0.4;  // of the cells that it is led on over
constexpr double kLeastMore_m = 0.1;     // less is the blur of its end
constexpr double kExplained = 1.5;       // cells from a wall, which was struck there then

class WallExtension {
 public:
  WallExtension(WallMap& map, const FloorGrid& floor) : walls_(map.walls), floor_(floor) {
    for (std::size_t i = 0; i < walls_.size(); ++i) index_.add(walls_[i].segment, static_cast<int>(i));
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
    if (after_m > 0 || before_m > 0) index_.add(extended.segment, static_cast<int>(wall));
  }

 private:
  double goes_on_m(const Vec2& p_map_end, const Vec2& along) {
    const double step_m = floor_.cell_m();
    int last = 0, struck = 0;
    for (int step = 1; (step - last) * step_m <= kGapMax_m; ++step) {
      if (!is_struck(p_map_end + (step - 0.5) * step_m * along, left_normal(along))) continue;
      last = step;
      ++struck;
    }
    const bool is_wall = last * step_m >= kLeastMore_m && struck >= kStruckShareMin * last;
    return is_wall ? last * step_m : 0;
  }

  /// By what no wall explains; a cell to either side, as cells are coarse.
  bool is_struck(const Vec2& p_map, const Vec2& across) {
    for (const int beside : {0, -1, 1}) {
      const Vec2 p_map_beside = p_map + beside * floor_.cell_m() * across;
      if (floor_.at(p_map_beside) == Floor::kOccupied &&
          !is_explained(floor_.centre(floor_.cell_at(p_map_beside))))
        return true;
    }
    return false;
  }

  bool is_explained(const Vec2& p_map) {
    const double near_m = kExplained * floor_.cell_m();
    index_.query(p_map, p_map, near_m, near_);
    return std::any_of(near_.begin(), near_.end(), [&](int wall) {
      return walls_[static_cast<std::size_t>(wall)].segment.distance(p_map) < near_m;
    });
  }

  std::vector<Wall>& walls_;
  const FloorGrid& floor_;
  CellIndex index_;
  std::vector<int> near_;
};

}  // namespace

void extend_walls(WallMap& map, const FloorGrid& floor) {
  WallExtension extension(map, floor);
  for (std::size_t wall = 0; wall < map.walls.size(); ++wall) extension.extend(wall);
}

}  // namespace aisle
