#include "floor/floor_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr double kHalfReach = 0.03;  // of the depth: half of what a step must last, a skirting board at least
constexpr int kHalfReachMin = 2, kHalfReachMax = 12;  // rows
constexpr int kStepPartsMax = 4;  // of the rows on either side, all of which show the step
constexpr float kWorthMax =
    20;  // grey levels: the most that one step counts, so that it does not outvote many
constexpr float kLeftBeneath = 0.6F;  // cost of a step that is left beneath, as a share of its worth
constexpr float kBeneathMax = 14;     // worth of several steps on the floor, which a wall's step must exceed
constexpr float kPerRow = 0.15F;      // cost of each row up or down to the next column ...
constexpr float kJump = 40;           // ... but no more than this
constexpr int kSettleRows = 2;        // rows to either side in which a step's steepest place is

int reach_at(const LevelView& view, int row) {
  return std::clamp(static_cast<int>(kHalfReach * view.depth(row)), kHalfReachMin, kHalfReachMax);
}

}  // namespace

const std::vector<BoundaryPoint>& FloorBoundary::find(const LevelView& view) {
  steps_.clear();
  if (view.columns() == 0 || view.rows() == 0) return find_again(view);
  rows_ = view.rows();
  const auto rows = static_cast<std::size_t>(rows_);
  steps_.assign(static_cast<std::size_t>(view.columns()) * rows, 0);
  froms_.resize(steps_.size());
  sums_.resize(rows + 1);
  set_reaches(view);
  for (int column = 0; column < view.columns(); ++column) {
    measure_steps(view, column);
    thin(view, column);
  }
  return find_again(view);
}

const std::vector<BoundaryPoint>& FloorBoundary::find_again(const LevelView& view) {
  points_.clear();
  if (steps_.empty()) return points_;
  costs_.assign(static_cast<std::size_t>(rows_), 0);
  crossed_.assign(static_cast<std::size_t>(rows_), 0);
  for (int column = 0; column < view.columns(); ++column) {
    if (column > 0) cross_to_next(column);
    weigh(column);
  }
  trace_back(view);
  return points_;
}

void FloorBoundary::exclude(const LevelView& view, const BoundaryPoint& point) {
  const auto column = static_cast<int>(point.column), row = static_cast<int>(std::lround(point.row));
  const LevelView::Rows seen = view.seen(column);
  const int reach = 2 * reaches_[static_cast<std::size_t>(row)];
  float* steps = &steps_[index(column, 0)];
  std::fill(steps + std::max(row - reach, seen.first), steps + std::min(row + reach + 1, seen.end), 0.0F);
}

void FloorBoundary::set_reaches(const LevelView& view) {
  reaches_.clear();
  bands_.clear();
  for (int row = 0; row < rows_; ++row) {
    const int reach = reach_at(view, row);
    reaches_.push_back(reach);
    if (bands_.empty() || bands_.back().reach != reach) bands_.push_back({.first = row, .reach = reach});
    bands_.back().end = row + 1;
  }
}

void FloorBoundary::sum_brightness(const std::uint8_t* brightness, LevelView::Rows seen) {
  int sum = 0;
  for (int row = seen.first; row < seen.end; ++row) {
    sums_[static_cast<std::size_t>(row)] = sum;
    sum += brightness[row];
  }
  sums_[static_cast<std::size_t>(seen.end)] = sum;
}

void FloorBoundary::measure_steps(const LevelView& view, int column) {
  const LevelView::Rows seen = view.seen(column);
  if (seen.count() == 0) return;
  sum_brightness(view.column(column), seen);
  for (const Band& band : bands_) measure_band(band, seen, &steps_[index(column, 0)]);
}

/// The step of a row lies above it. Where there are enough rows, a stripe as wide as half of what must last
/// is no step.
void FloorBoundary::measure_band(const Band& band, LevelView::Rows seen, float* steps) const {
  const int* sums = sums_.data();
  const int reach = band.reach;
  const int first = std::max(band.first, seen.first + 2 * reach);
  const int end = std::min(band.end, seen.end - 2 * reach + 1);
  const int parts = std::clamp(reach, 2, kStepPartsMax);
  const auto bound = [&](int part) { return 2 * reach * part / parts; };
  const auto mean = [&](int from, int to) {
    return static_cast<float>(sums[to] - sums[from]) / static_cast<float>(to - from);
  };
  for (int row = first; row < end; ++row) {
    float beyond_least = 255, beyond_most = 0, near_least = 255, near_most = 0;
    for (int part = 0; part < parts; ++part) {
      const float beyond = mean(row - bound(part + 1), row - bound(part));
      const float near = mean(row + bound(part), row + bound(part + 1));
      beyond_least = std::min(beyond_least, beyond);
      beyond_most = std::max(beyond_most, beyond);
      near_least = std::min(near_least, near);
      near_most = std::max(near_most, near);
    }
    const float brighter = beyond_least - near_most, darker = near_least - beyond_most;
    steps[row] = brighter > 0 ? brighter : -std::max(0.0F, darker);
  }
}

/// Keeps the greatest of neighbouring steps.
void FloorBoundary::thin(const LevelView& view, int column) {
  const LevelView::Rows seen = view.seen(column);
  float* steps = &steps_[index(column, 0)];
  int peak = seen.first;
  for (int row = seen.first + 1; row < seen.end; ++row) {
    if (row - peak > reaches_[static_cast<std::size_t>(row)]) peak = row;
    if (steps[row] == 0 || row == peak) continue;
    if (std::abs(steps[row]) > std::abs(steps[peak])) {
      steps[peak] = 0;
      peak = row;
    } else {
      steps[row] = 0;
    }
  }
}

/// A row gains by its own step, and pays for the steps beneath it.
void FloorBoundary::weigh(int column) {
  const float* steps = &steps_[index(column, 0)];
  float* costs = costs_.data();
  const auto contrast_min = static_cast<float>(contrast_min_);
  float beneath = 0;
  cheapest_row_ = rows_ - 1;
  for (int row = rows_ - 1; row >= 0; --row) {
    const float worth = std::clamp(std::abs(steps[row]) - contrast_min, 0.0F, kWorthMax);
    costs[row] += kLeftBeneath * beneath - worth;
    beneath = std::min(beneath + worth, kBeneathMax);
    if (costs[row] <= costs[cheapest_row_]) cheapest_row_ = row;
  }
}

/// The cheapest way to each row of a column from the previous column.
void FloorBoundary::cross_to_next(int column) {
  std::int16_t* from = &froms_[index(column, 0)];
  const float* costs = costs_.data();
  float* crossed = crossed_.data();
  const int jump_from = cheapest_row_;
  const float jump = costs[jump_from] + kJump;
  float best = jump;
  int best_from = jump_from;
  const auto come_to = [&](int row) {
    best += kPerRow;
    const bool begins_here = costs[row] <= best;
    best = begins_here ? costs[row] : best;
    best_from = begins_here ? row : best_from;
  };
  for (int row = 0; row < rows_; ++row) {
    come_to(row);
    crossed[row] = best;
    from[row] = static_cast<std::int16_t>(best_from);
  }
  best = jump;
  best_from = jump_from;
  for (int row = rows_ - 1; row >= 0; --row) {
    come_to(row);
    int row_from = best < crossed[row] ? best_from : from[row];
    const float by_row = std::min(crossed[row], best);
    row_from = jump < by_row ? jump_from : row_from;
    crossed[row] = std::min(by_row, jump);
    from[row] = static_cast<std::int16_t>(row_from);
  }
  costs_.swap(crossed_);
}

void FloorBoundary::trace_back(const LevelView& view) {
  path_.resize(static_cast<std::size_t>(view.columns()));
  int row = cheapest_row_;
  for (int column = view.columns() - 1; column >= 0; --column) {
    path_[static_cast<std::size_t>(column)] = row;
    if (column > 0) row = froms_[index(column, row)];
  }
  for (int column = 0; column < view.columns(); ++column)
    add_point(view, column, path_[static_cast<std::size_t>(column)]);
}

/// Brings a step to the steepest place near it.
void FloorBoundary::add_point(const LevelView& view, int column, int row) {
  const LevelView::Rows seen = view.seen(column);
  const double contrast = steps_[index(column, row)];
  if (std::abs(contrast) < contrast_min_) return;
  const std::uint8_t* grey = view.column(column);
  const double sign = contrast > 0 ? 1 : -1;
  const auto steepness = [&](int at) {
    return sign * (grey[at - 2] + 2.0 * grey[at - 1] - 2.0 * grey[at] - grey[at + 1]);
  };
  const int first = std::max(row - kSettleRows, seen.first + 3),
            last = std::min(row + kSettleRows, seen.end - 3);
  if (first > last) return;
  int steepest = first;
  for (int at = first + 1; at <= last; ++at)
    if (steepness(at) > steepness(steepest)) steepest = at;
  const double here = steepness(steepest), above = steepness(steepest - 1), beneath = steepness(steepest + 1);
  const double bend = above - 2 * here + beneath;
  const double off = bend < 0 ? std::clamp(0.5 * (above - beneath) / bend, -0.5, 0.5) : 0;
  points_.push_back(
      {.column = static_cast<double>(column), .row = steepest - 0.5 + off, .contrast = contrast});
}

}  // namespace aisle
