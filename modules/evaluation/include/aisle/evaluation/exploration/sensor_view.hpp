#pragma once
/// What a sensor can see of a world's floor and walls: the ground truth that an exploration is judged by.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/wall_grid.hpp"

namespace aisle {

/// How a sensor on a vehicle looks at walls.
struct SensorField {
  Pose2 T_vehicle_sensor;
  double reach_m = 6;
  double width_rad = 180 * kDegree;  ///< field of view, symmetric about straight ahead
  double height_m = 0.3;             ///< at which walls are seen
};

/// The cells of a floor that rays passed, and those in which rays hit a wall.
class SensorView {
 public:
  /// @param walls  what stops a ray; at least one
  explicit SensorView(std::span<const Segment2> walls);

  /// Casts one ray per degree. @param width_rad  field of view; 2 pi: all round
  void look(const Pose2& T_world_sensor, double reach_m, double width_rad);

  double cell_m() const { return cell_m_; }
  std::size_t size() const { return marks_.size(); }
  Vec2 centre(std::size_t cell) const;
  bool is_open_floor(std::size_t cell) const { return marks_[cell] == kPassed; }
  /// Whether rays passed the cell or one beside it: rays leave gaps of a cell.
  bool is_passed_nearby(std::size_t cell) const { return has_nearby(cell, kPassed); }
  /// Whether a ray hit a wall within a cell of this point.
  bool is_hit(const Vec2& p_world) const;

 private:
  static constexpr std::uint8_t kPassed = 1;
  static constexpr std::uint8_t kHit = 2;

  bool contains(long column, long row) const {
    return column >= 0 && column < columns_ && row >= 0 && row < rows_;
  }
  bool has_nearby(std::size_t cell, std::uint8_t mark) const;
  void mark(const Vec2& p_world, std::uint8_t mark);

  WallGrid grid_;
  Vec2 corner_ = Vec2::Zero();  ///< lower left corner of cell (0, 0)
  double cell_m_ = 0.05;
  long columns_ = 0;
  long rows_ = 0;
  std::vector<std::uint8_t> marks_;
};

}  // namespace aisle
