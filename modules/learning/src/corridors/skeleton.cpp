#include "corridors/skeleton.hpp"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace aisle {
namespace {

constexpr int kSlopeReach_cells = 3;  ///< over which the slope of the clearance is measured

class Thinning {
 public:
  Thinning(const ClearFloor& floor, std::vector<bool> area) : floor_(floor), area_(std::move(area)) {}

  /// Removes all removable cells, least clearance first.
  void thin_to(const std::function<bool(std::size_t)>& must_stay) {
    using Entry = std::pair<double, std::size_t>;  // clearance, cell
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto look_at = [&](std::size_t cell) {
      if (area_[cell] && is_simple(cell)) open.emplace(floor_.clearance_m(cell), cell);
    };
    for (std::size_t cell = 0; cell < area_.size(); ++cell) look_at(cell);
    while (!open.empty()) {
      const std::size_t cell = open.top().second;
      open.pop();
      if (!area_[cell] || !is_simple(cell) || must_stay(cell)) continue;
      area_[cell] = false;
      for (const std::size_t next : cells_around(floor_, cell)) look_at(next);
    }
  }

  /// Thins lines to one cell, one side after the other, so that none gets shorter by more than its width.
  void thin_lines() {
    for (bool is_thinner = true; is_thinner;) {
      is_thinner = false;
      for (const std::size_t side : {0U, 4U, 2U, 6U}) is_thinner |= thin_from(side);
    }
  }

  std::vector<bool> take() && { return std::move(area_); }

 private:
  bool thin_from(std::size_t side) {
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < area_.size(); ++cell) {
      if (area_[cell] && !area_[cells_around(floor_, cell)[side]] && can_go(cell)) cells.push_back(cell);
    }
    bool is_thinner = false;
    for (const std::size_t cell : cells) {
      if (!can_go(cell)) continue;
      area_[cell] = false;
      is_thinner = true;
    }
    return is_thinner;
  }

  bool can_go(std::size_t cell) const {
    int neighbours = 0;
    for (const std::size_t next : cells_around(floor_, cell)) neighbours += area_[next] ? 1 : 0;
    return neighbours > 1 && is_simple(cell);
  }

  /// Whether the area stays connected without the cell: its area neighbours are one piece (corners count),
  /// and at least one of its sides is outside the area.
  bool is_simple(std::size_t cell) const {
    const auto around = cells_around(floor_, cell);
    int pieces = 0;
    for (std::size_t i = 0; i < 8; i += 2) {
      const bool side = area_[around[i]], corner = area_[around[i + 1]], next = area_[around[(i + 2) % 8]];
      if (!side && (corner || next)) ++pieces;
    }
    return pieces == 1;
  }

  const ClearFloor& floor_;
  std::vector<bool> area_;
};

bool is_ridge(const ClearFloor& floor, std::size_t cell, double slope_max) {
  const int column = floor.column_of(cell), row = floor.row_of(cell);
  for (int y = -kSlopeReach_cells; y <= kSlopeReach_cells; ++y) {
    for (int x = -kSlopeReach_cells; x <= kSlopeReach_cells; ++x) {
      const double distance_cells = std::hypot(x, y);
      if (distance_cells < kSlopeReach_cells - 0.5 || distance_cells > kSlopeReach_cells + 0.5) continue;
      if (column + x < 0 || row + y < 0 || column + x >= floor.columns() || row + y >= floor.rows()) continue;
      const double rise_m = floor.clearance_m(floor.cell_at(column + x, row + y)) - floor.clearance_m(cell);
      if (rise_m > slope_max * distance_cells * floor.cell_m()) return false;
    }
  }
  return true;
}

}  // namespace

std::array<std::size_t, 8> cells_around(const ClearFloor& floor, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(floor.columns());
  return {cell + 1, cell + columns + 1, cell + columns, cell + columns - 1,
          cell - 1, cell - columns - 1, cell - columns, cell - columns + 1};
}

std::vector<bool> skeleton(const ClearFloor& floor, std::vector<bool> area, double ridge_slope_max) {
  Thinning thinning(floor, std::move(area));
  thinning.thin_to([&](std::size_t cell) { return is_ridge(floor, cell, ridge_slope_max); });
  thinning.thin_lines();
  return std::move(thinning).take();
}

}  // namespace aisle
