#include "route/step_costs.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

Cost difference(const CellLook& a, const CellLook& b, double colour_weight) {
  const double brightness = a.brightness - b.brightness;
  const double red_green = colour_weight * (a.red_green - b.red_green);
  const double yellow_blue = colour_weight * (a.yellow_blue - b.yellow_blue);
  return static_cast<Cost>(
      std::sqrt(brightness * brightness + red_green * red_green + yellow_blue * yellow_blue));
}

bool lower(Cost& cost, Cost other) {
  if (other >= cost) return false;
  cost = other;
  return true;
}

CellLook mean(const CellLook& a, const CellLook& b) {
  return {(a.brightness + b.brightness) / 2, (a.red_green + b.red_green) / 2,
          (a.yellow_blue + b.yellow_blue) / 2};
}

}  // namespace

Cost StepCosts::texture_of(const CellGrid& grid, const CellBlock& block, double colour_weight) {
  // Among equal independent looks, steps are this much larger than distances from the mean of two others.
  const double step_per_distance = std::sqrt(2 / 1.5);
  distances_.clear();
  for (int row = block.first_row; row < block.end_row; ++row) {
    for (int column = std::max(1, block.first_column); column < std::min(block.end_column, grid.columns - 1);
         ++column) {
      const std::size_t i = grid.index(row, column);
      distances_.push_back(
          difference(grid.looks[i], mean(grid.looks[i - 1], grid.looks[i + 1]), colour_weight));
    }
  }
  if (distances_.empty()) return 0;
  return static_cast<Cost>(step_per_distance * median_reordering(std::span(distances_)));
}

void StepCosts::take(const CellGrid& grid, double colour_weight, Cost quiet_step) {
  columns_ = grid.columns;
  rows_ = grid.rows;
  right_.assign(grid.looks.size(), kNoPath);
  down_.assign(grid.looks.size(), kNoPath);
  const auto step = [&](const CellLook& a, const CellLook& b) {
    return 1 + std::max(0, difference(a, b, colour_weight) - quiet_step);
  };
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t i = grid.index(row, column);
      if (column + 1 < columns_) right_[i] = step(grid.looks[i], grid.looks[i + 1]);
      if (row + 1 < rows_) down_[i] = step(grid.looks[i], grid.looks[grid.index(row + 1, column)]);
    }
  }
}

/// Lowers a row's costs by those of the row it is reached from, then by each other, both ways.
bool StepCosts::spread_row(int row, int from_row, std::vector<Cost>& costs) const {
  const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
  const std::size_t end = first + static_cast<std::size_t>(columns_);
  bool changed = false;
  if (from_row >= 0 && from_row < rows_) {
    const std::size_t from = static_cast<std::size_t>(from_row) * static_cast<std::size_t>(columns_);
    const std::size_t upper = std::min(first, from);
    for (std::size_t k = 0; first + k < end; ++k)
      changed |= lower(costs[first + k], costs[from + k] + down_[upper + k]);
  }
  for (std::size_t i = first + 1; i < end; ++i) changed |= lower(costs[i], costs[i - 1] + right_[i - 1]);
  for (std::size_t i = end - 1; i > first; --i) changed |= lower(costs[i - 1], costs[i] + right_[i - 1]);
  return changed;
}

void StepCosts::spread(std::vector<Cost>& costs) const {
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < rows_; ++row) changed |= spread_row(row, row - 1, costs);
    for (int row = rows_ - 1; row >= 0; --row) changed |= spread_row(row, row + 1, costs);
  }
}

}  // namespace aisle
