#pragma once

#include <optional>
#include <vector>

#include "floor/floor_boundary.hpp"
#include "line_fit.hpp"

namespace aisle {

/// A straight piece of the floor's boundary in a level view: row = row_middle + slope (column - middle).
struct FloorLine {
  double first_column = 0, last_column = 0;
  double row_middle = 0, slope = 0;
  double sigma_row = 0;    ///< of row_middle
  double sigma_slope = 0;  ///< of the slope
  double contrast = 0;     ///< mean of its points

  double middle() const { return 0.5 * (first_column + last_column); }
  double row_at(double column) const { return row_middle + slope * (column - middle()); }
};

/// Fits straight lines to the points of a boundary, the longest first; points off them are left out. A line
/// ends where the boundary bends or steps to the side, as at a door's recess, however little, if that is
/// clear.
class FloorLineFitter {
 public:
  /// From left to right; valid until the next call.
  /// @param rows_per_column  how many rows are as long as the distance between two columns
  const std::vector<FloorLine>& fit(const std::vector<BoundaryPoint>& points, double rows_per_column);

 private:
  struct Run {
    std::size_t a = 0, b = 0;        ///< the points that it was begun with
    std::size_t first = 0, end = 0;  ///< of points
    double row = 0, slope = 0;       ///< row at column 0
    double off_max_rows = 0;         ///< a point that is farther off is not on it
    std::size_t count = 0;           ///< of the points that lie on it

    bool has(const BoundaryPoint& point) const;
  };

  void begin_runs();
  void grow(Run& run) const;
  Run longest_straight_part(Run run);
  std::optional<std::size_t> bend_between(std::size_t first, std::size_t end) const;
  void take(const Run& run);
  void grow_without(const Run& taken);

  const std::vector<BoundaryPoint>* points_ = nullptr;
  double rows_per_column_ = 1;
  std::vector<char> taken_;
  std::vector<Run> runs_;
  std::vector<std::size_t> on_run_;  ///< its points
  std::vector<Vec2> bend_points_;    ///< the same, in rows either way
  RangeLineFitter range_fitter_;
  std::vector<FloorLine> lines_;
};

}  // namespace aisle
