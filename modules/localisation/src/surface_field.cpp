#include "aisle/localisation/surface_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aisle/geometry/box2.hpp"

namespace aisle {
namespace {

constexpr double kMargin_m = 1;       // around the building
constexpr double kExplained_m = 0.1;  // occupied floor this near to a wall is that wall
constexpr double kSurfaceCell_m = 0.7 * SurfaceField::kCell_m;  // of the cells that a surface runs through
constexpr double kCarried_m = 1;  // what is smaller than this can be carried away
constexpr std::size_t kCellsMax = 200'000'000;

Box2 box_of(const Building& building) {
  Box2 box = box_around(building.walls.walls, &Wall::segment);
  if (building.floor && !building.floor->known().empty()) {
    const FloorBox& known = building.floor->known();
    box.extend(building.floor->centre(known.low)).extend(building.floor->centre(known.end));
  }
  return box;
}

}  // namespace

SurfaceField::SurfaceField(const Building& building) {
  size_grid(building);
  add_walls(building.walls);
  sweep();
  if (building.floor) {
    add_occupied_floor(*building.floor);
    sweep();
  }
  if (surfaces_.empty())
    throw std::invalid_argument("a building to be found in needs walls or occupied floor");
  mark_fixed();
  mark_floor(building);
}

void SurfaceField::size_grid(const Building& building) {
  const Box2 box = box_of(building);
  if (box.isEmpty()) throw std::invalid_argument("a building to be found in needs walls or a floor");
  p_map_corner_ = box.min().array() - kMargin_m;
  const Vec2 cells = (box.sizes().array() + 2 * kMargin_m) / kCell_m;
  if (!(cells.prod() < static_cast<double>(kCellsMax)))
    throw std::invalid_argument("the building is too large");
  columns_ = static_cast<int>(std::ceil(cells.x()));
  rows_ = static_cast<int>(std::ceil(cells.y()));
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  nearest_.assign(count, -1);
  distance_m_.assign(count, static_cast<float>(kFar_m));
}

void SurfaceField::offer(int column, int row, int surface) {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  const auto cell =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  const auto distance_m =
      static_cast<float>(surfaces_[static_cast<std::size_t>(surface)].segment.distance(centre(column, row)));
  if (distance_m >= distance_m_[cell]) return;
  distance_m_[cell] = distance_m;
  nearest_[cell] = surface;
}

void SurfaceField::add_walls(const WallMap& walls) {
  for (const Wall& wall : walls.walls) {
    const Vec2 along = wall.segment.end - wall.segment.start;
    const double length_m = along.norm();
    if (!(length_m > 0)) continue;
    const int surface = static_cast<int>(surfaces_.size());
    surfaces_.push_back({wall.segment, left_normal(along / length_m)});
    const int steps = static_cast<int>(std::ceil(length_m / kCell_m));
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = (wall.segment.start + along * i / steps - p_map_corner_) / kCell_m;
      const int column = static_cast<int>(p.x()), row = static_cast<int>(p.y());
      for (int k = 0; k < 9; ++k) offer(column + k % 3 - 1, row + k / 3 - 1, surface);
    }
  }
}

void SurfaceField::add_occupied_floor(const FloorGrid& floor) {
  const FloorBox& known = floor.known();
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) {
      if (floor.at(FloorCell{x, y}) != Floor::kOccupied) continue;
      const Vec2 p_map = floor.centre({x, y});
      const Surface* const wall = nearest(p_map);
      if (wall != nullptr && wall->is_wall() && wall->segment.distance(p_map) < kExplained_m) continue;
      surfaces_.push_back({{p_map, p_map}, Vec2::Zero()});
      const Vec2 p = (p_map - p_map_corner_) / kCell_m;
      offer(static_cast<int>(p.x()), static_cast<int>(p.y()), static_cast<int>(surfaces_.size()) - 1);
    }
  }
}

void SurfaceField::take_from(std::size_t cell, std::size_t neighbour, const Vec2& p_map) {
  const int surface = nearest_[neighbour];
  if (surface < 0 || surface == nearest_[cell]) return;
  const auto distance_m =
      static_cast<float>(surfaces_[static_cast<std::size_t>(surface)].segment.distance(p_map));
  if (distance_m >= distance_m_[cell]) return;
  distance_m_[cell] = distance_m;
  nearest_[cell] = surface;
}

/// Carries the nearest surface from cell to cell, from all sides (Danielsson 1980).
void SurfaceField::sweep() {
  const auto width = static_cast<std::ptrdiff_t>(columns_);
  const auto pass = [&](int row, int from_row, bool to_the_right) {
    for (int i = 0; i < columns_; ++i) {
      const int column = to_the_right ? i : columns_ - 1 - i;
      const Vec2 p_map = centre(column, row);
      const auto cell = static_cast<std::size_t>(row * width + column);
      const int behind = to_the_right ? column - 1 : column + 1;
      if (behind >= 0 && behind < columns_)
        take_from(cell, static_cast<std::size_t>(row * width + behind), p_map);
      if (from_row < 0 || from_row >= rows_) continue;
      for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
        take_from(cell, static_cast<std::size_t>(from_row * width + c), p_map);
    }
  };
  for (const bool to_the_right : {true, false}) {
    for (int row = 0; row < rows_; ++row) pass(row, row - 1, to_the_right);
    for (int row = rows_ - 1; row >= 0; --row) pass(row, row + 1, to_the_right);
  }
}

/// Surfaces that touch are one thing. Chairs, boxes and table legs are carried about; walls are not.
void SurfaceField::mark_fixed() {
  std::vector<std::uint8_t> is_visited(nearest_.size());
  for (std::size_t cell = 0; cell < nearest_.size(); ++cell) {
    const std::vector<std::size_t> thing = connected_surface(cell, is_visited);
    if (thing.empty()) continue;
    Box2 box;
    for (const std::size_t part : thing) {
      const std::size_t row = part / static_cast<std::size_t>(columns_);
      const std::size_t column = part % static_cast<std::size_t>(columns_);
      box.extend(Vec2(static_cast<double>(column), static_cast<double>(row)));
    }
    if (kCell_m * box.diagonal().norm() < kCarried_m) continue;
    for (const std::size_t part : thing) surfaces_[static_cast<std::size_t>(nearest_[part])].is_fixed = true;
  }
}

/// All cells on surfaces that touch one another, from one of them on; none if it is not on a surface.
std::vector<std::size_t> SurfaceField::connected_surface(std::size_t from,
                                                         std::vector<std::uint8_t>& is_visited) const {
  std::vector<std::size_t> thing;
  const auto take = [&](std::size_t cell) {
    if (is_visited[cell] != 0 || !(distance_m_[cell] <= kSurfaceCell_m)) return;
    is_visited[cell] = 1;
    thing.push_back(cell);
  };
  const auto width = static_cast<std::size_t>(columns_);
  take(from);
  for (std::size_t i = 0; i < thing.size(); ++i) {
    const std::size_t column = thing[i] % width, row = thing[i] / width;
    for (std::size_t r = row - std::min<std::size_t>(row, 1);
         r <= std::min(row + 1, nearest_.size() / width - 1); ++r) {
      for (std::size_t c = column - std::min<std::size_t>(column, 1); c <= std::min(column + 1, width - 1);
           ++c)
        take(r * width + c);
    }
  }
  return thing;
}

void SurfaceField::mark_floor(const Building& building) {
  const bool is_known = building.floor && building.floor->count(Floor::kFree) > 0;
  can_stand_.assign(nearest_.size(), is_known ? 0 : 1);
  if (!is_known) return;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(column);
      can_stand_[cell] = building.floor->at(centre(column, row)) == Floor::kFree ? 1 : 0;
    }
  }
}

}  // namespace aisle
