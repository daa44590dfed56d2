#include "floor_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr double kHalfReach = 0.03;  // of the depth: half of what a step must last, a skirting board at least
constexpr int kHalfReachMin = 2, kHalfReachMax = 12;  // rows
constexpr float kWorthMax = 20;                       // grey levels; one strong step is not to outvote many
constexpr float kLeftBeneath = 0.6F;  // cost of a step that is left beneath, as a share of its worth
constexpr float kBeneathMax = 14;     // worth of several steps on the floor, which a wall's step is to outdo
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

void FloorBoundary::strike_out(const LevelView& view, const BoundaryPoint& point) {
  const auto column = static_cast<int>(point.column), row = static_cast<int>(std::lround(point.row));
  const LevelView::Rows seen = view.seen(column);
  const int reach = 2 * reach_at(view, row);
  float* steps = &steps_[index(column, 0)];
  std::fill(steps + std::max(row - reach, seen.first), steps + std::min(row + reach + 1, seen.end), 0.0F);
}

void FloorBoundary::sum_brightness(const std::uint8_t* brightness, LevelView::Rows seen) {
  int sum = 0;
  for (int row = seen.first; row < seen.end; ++row) {
    sums_[static_cast<std::size_t>(row)] = sum;
    sum += brightness[row];
  }
  sums_[static_cast<std::size_t>(seen.end)] = sum;
}

/// The step of a row lies above it.
void FloorBoundary::measure_steps(const LevelView& view, int column) {
  const LevelView::Rows seen = view.seen(column);
  if (seen.count() == 0) return;
  sum_brightness(view.column(column), seen);
  float* steps = &steps_[index(column, 0)];
  const int* sums = sums_.data();
  for (int row = seen.first + 2 * kHalfReachMin; row + 2 * kHalfReachMin <= seen.end; ++row) {
    const int reach = reach_at(view, row);
    if (row - 2 * reach < seen.first || row + 2 * reach > seen.end) continue;
    const int farther = sums[row - reach] - sums[row - 2 * reach], far = sums[row] - sums[row - reach];
    const int near = sums[row + reach] - sums[row], nearer = sums[row + 2 * reach] - sums[row + reach];
    const int brighter = std::min(far, farther) - std::max(near, nearer);
    const int darker = std::min(near, nearer) - std::max(far, farther);
    const int step = brighter > 0 ? brighter : -std::max(0, darker);
    steps[row] = static_cast<float>(step) / static_cast<float>(reach);
  }
}

/// Leaves the greatest of neighbouring steps.
void FloorBoundary::thin(const LevelView& view, int column) {
  const LevelView::Rows seen = view.seen(column);
  float* steps = &steps_[index(column, 0)];
  int peak = seen.first;
  for (int row = seen.first + 1; row < seen.end; ++row) {
    if (row - peak > reach_at(view, row)) peak = row;
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
  float beneath = 0;
  for (int row = rows_ - 1; row >= 0; --row) {
    const float step = std::abs(steps[row]) - static_cast<float>(contrast_min_);
    const float worth = std::clamp(step, 0.0F, kWorthMax);
    costs_[static_cast<std::size_t>(row)] += kLeftBeneath * beneath - worth;
    beneath = std::min(beneath + worth, kBeneathMax);
  }
}

/// The cheapest way to each row of a column from the column before.
void FloorBoundary::cross_to_next(int column) {
  std::int16_t* from = &froms_[index(column, 0)];
  const auto rows = static_cast<std::size_t>(rows_);
  const auto least = std::min_element(costs_.begin(), costs_.end());
  const float jump = *least + kJump;
  const auto jump_from = static_cast<std::int16_t>(least - costs_.begin());
  float best = jump;
  std::int16_t best_from = jump_from;
  for (std::size_t row = 0; row < rows; ++row) {
    best += kPerRow;
    if (costs_[row] <= best) {
      best = costs_[row];
      best_from = static_cast<std::int16_t>(row);
    }
    crossed_[row] = best;
    from[row] = best_from;
  }
  best = jump;
  best_from = jump_from;
  for (std::size_t row = rows; row-- > 0;) {
    best += kPerRow;
    if (costs_[row] <= best) {
      best = costs_[row];
      best_from = static_cast<std::int16_t>(row);
    }
    if (best < crossed_[row]) {
      crossed_[row] = best;
      from[row] = best_from;
    }
    if (jump < crossed_[row]) {
      crossed_[row] = jump;
      from[row] = jump_from;
    }
  }
  costs_.swap(crossed_);
}

void FloorBoundary::trace_back(const LevelView& view) {
  path_.resize(static_cast<std::size_t>(view.columns()));
  auto row = static_cast<int>(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
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
