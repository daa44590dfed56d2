#pragma once
/// What a range scanner can hit in a known building, and where a vehicle can stand, as one grid.

#include <cstdint>
#include <vector>

#include "aisle/maps/building.hpp"

namespace aisle {

/// A piece of a surface: a wall, or an occupied cell of the floor that no wall explains.
struct Surface {
  Segment2 segment;            ///< of a cell: a point
  Vec2 normal = Vec2::Zero();  ///< of a wall, unit, towards its free side; zero: it may face anywhere
  bool is_fixed = false;       ///< part of something that nobody carries away: of 1 m or more

  bool is_wall() const { return !normal.isZero(); }
};

/// The nearest surface to every place of a building. Building it costs O(cells); every question O(1).
class SurfaceField {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kFar_m = 2.5;  ///< distances are known up to this

  /// @throws std::invalid_argument if the building has neither walls nor occupied floor, or is too large
  explicit SurfaceField(const Building& building);

  /// Distance from a point to the nearest surface, at most kFar_m; exact to half a cell.
  double distance_m(const Vec2& p_map) const {
    const long cell = index_of(p_map);
    return cell < 0 ? kFar_m : distance_m_[static_cast<std::size_t>(cell)];
  }
  /// The surface nearest to the point's cell; null: none within kFar_m.
  const Surface* nearest(const Vec2& p_map) const {
    const long cell = index_of(p_map);
    const int surface = cell < 0 ? -1 : nearest_[static_cast<std::size_t>(cell)];
    return surface < 0 ? nullptr : &surfaces_[static_cast<std::size_t>(surface)];
  }
  /// Floor that was seen free; in a building without a floor, everywhere within its walls' box.
  bool can_stand(const Vec2& p_map) const {
    const long cell = index_of(p_map);
    return cell >= 0 && can_stand_[static_cast<std::size_t>(cell)] != 0;
  }

  const Vec2& corner_m() const { return p_map_corner_; }  ///< lower left corner of the grid, in the map
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  Vec2 centre(int column, int row) const { return p_map_corner_ + kCell_m * Vec2(column + 0.5, row + 0.5); }

 private:
  long index_of(const Vec2& p_map) const {
    const Vec2 p = (p_map - p_map_corner_) / kCell_m;
    if (!(p.x() >= 0 && p.y() >= 0 && p.x() < columns_ && p.y() < rows_)) return -1;
    return static_cast<long>(p.y()) * columns_ + static_cast<long>(p.x());
  }
  void size_grid(const Building& building);
  void add_walls(const WallMap& walls);
  void add_occupied_floor(const FloorGrid& floor);
  void offer(int column, int row, int surface);
  void take_from(std::size_t cell, std::size_t neighbour, const Vec2& p_map);
  void sweep();
  void mark_fixed();
  std::vector<std::size_t> connected_surface(std::size_t from, std::vector<std::uint8_t>& is_visited) const;
  void mark_floor(const Building& building);

  Vec2 p_map_corner_ = Vec2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Surface> surfaces_;
  std::vector<int> nearest_;       ///< per cell, index in `surfaces_`; -1: none near
  std::vector<float> distance_m_;  ///< per cell
  std::vector<std::uint8_t> can_stand_;
};

}  // namespace aisle
