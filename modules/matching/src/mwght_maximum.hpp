#pragma once
/// Maxima of H, found in two ways.

#include <cmath>
#include <optional>

#include "mwght_votes.hpp"

namespace aisle {

struct MwghtMaximum {
  MwghtCell cell;
  double value = 0;

  /// Of equal values the first by (turn, y, x) wins.
  bool beats(const MwghtMaximum& other) const {
    if (value != other.value) return value > other.value;
    if (cell.turn != other.cell.turn) return cell.turn < other.cell.turn;
    return cell.y != other.cell.y ? cell.y < other.cell.y : cell.x < other.cell.x;
  }
};

/// The cells that belong to the same hypothesis as one cell: near it and turned little against it.
class MwghtVicinity {
 public:
  MwghtVicinity(const MwghtParams& params, const MwghtCell& middle)
      : middle_(middle),
        apart_(params.apart_m / params.cell_m),
        turns_apart_(params.apart_rad / params.angle_step_rad) {}

  bool holds(const MwghtCell& cell) const {
    const double dx = cell.x - middle_.x, dy = cell.y - middle_.y;
    return std::abs(cell.turn - middle_.turn) <= turns_apart_ && dx * dx + dy * dy <= apart_ * apart_;
  }
  /// Whether it contains every cell of the square of `size` cells from `corner` on.
  bool holds_square(const MwghtCell& corner, int size) const {
    const auto farther = [size](int first, int middle) {
      const int last = first + size - 1;
      return middle - first > last - middle ? first : last;
    };
    return holds({farther(corner.x, middle_.x), farther(corner.y, middle_.y), corner.turn});
  }

 private:
  MwghtCell middle_;
  double apart_, turns_apart_;  ///< [cells], [angle steps]
};

}  // namespace aisle
