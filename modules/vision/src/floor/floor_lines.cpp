#include "floor/floor_lines.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "aisle/core/square.hpp"

namespace aisle {

namespace {

constexpr double kOffLine_px = 1;  // rows; a point off a line by more is not on it
constexpr double kGap = 4;         // columns without a point that a line may have
constexpr std::size_t kLinePointsMin = 5;
constexpr std::size_t kLinesMax = 12;
constexpr double kSigmaMin_px = 0.25;  // of a point's row
constexpr double kBendMin = 30;        // variances, by which two lines must fit better than one

}  // namespace

const std::vector<FloorLine>& FloorLineFitter::fit(const std::vector<BoundaryPoint>& points,
                                                   double rows_per_column) {
  points_ = &points;
  rows_per_column_ = rows_per_column;
  taken_.assign(points.size(), 0);
  lines_.clear();
  begin_runs();
  const auto is_shorter = [](const Run& a, const Run& b) { return a.count < b.count; };
  while (lines_.size() < kLinesMax) {
    const auto longest = std::max_element(runs_.begin(), runs_.end(), is_shorter);
    if (longest == runs_.end() || longest->count < kLinePointsMin) break;
    const Run run = longest_straight_part(*longest);
    take(run);
    grow_without(run);
  }
  std::sort(lines_.begin(), lines_.end(),
            [](const FloorLine& a, const FloorLine& b) { return a.first_column < b.first_column; });
  return lines_;
}

bool FloorLineFitter::Run::has(const BoundaryPoint& point) const {
  return std::abs(point.row - row - slope * point.column) < off_max_rows;
}

void FloorLineFitter::begin_runs() {
  const auto& points = *points_;
  runs_.clear();
  for (std::size_t a = 0; a < points.size(); a += 2) {
    for (const std::size_t apart : {4, 10, 24}) {
      if (a + apart >= points.size()) break;
      const BoundaryPoint &from = points[a], &to = points[a + apart];
      Run run{.a = a, .b = a + apart};
      run.slope = (to.row - from.row) / (to.column - from.column);
      run.row = from.row - run.slope * from.column;
      run.off_max_rows = kOffLine_px * std::hypot(1.0, run.slope / rows_per_column_);
      grow(run);
      runs_.push_back(run);
    }
  }
}

/// Ends runs before the points that were taken from them.
void FloorLineFitter::grow_without(const Run& taken) {
  for (Run& run : runs_) {
    const bool is_touched = run.first < taken.end && taken.first < std::max(run.end, run.b + 1);
    if (run.count > 0 && is_touched) grow(run);
  }
}

/// The line through two points as far as further points lie on it.
void FloorLineFitter::grow(Run& run) const {
  const auto& points = *points_;
  const std::size_t a = run.a;
  run.count = 0;
  if (taken_[a] != 0 || taken_[run.b] != 0) return;
  run.first = run.end = a;
  double column = points[a].column;
  for (std::size_t i = a; i < points.size() && points[i].column - column <= kGap; ++i) {
    if (taken_[i] != 0) break;
    if (!run.has(points[i])) continue;
    column = points[i].column;
    run.end = i + 1;
    ++run.count;
  }
  column = points[a].column;
  for (std::size_t i = a; i-- > 0 && column - points[i].column <= kGap;) {
    if (taken_[i] != 0) break;
    if (!run.has(points[i])) continue;
    column = points[i].column;
    run.first = i;
    ++run.count;
  }
}

/// Cuts a run while it has a bend, and keeps the longer part.
FloorLineFitter::Run FloorLineFitter::longest_straight_part(Run run) {
  on_run_.clear();
  bend_points_.clear();
  for (std::size_t i = run.first; i < run.end; ++i) {
    const BoundaryPoint& point = (*points_)[i];
    if (!run.has(point)) continue;
    on_run_.push_back(i);
    bend_points_.push_back({point.column * rows_per_column_, point.row});
  }
  range_fitter_.assign(bend_points_);
  std::size_t first = 0, end = on_run_.size();
  while (const auto bend = bend_between(first, end)) (*bend - first > end - *bend ? end : first) = *bend;
  run.first = on_run_[first];
  run.end = on_run_[end - 1] + 1;
  run.count = end - first;
  return run;
}

/// The first point of the second of two lines that explain some points on a run much better than one.
std::optional<std::size_t> FloorLineFitter::bend_between(std::size_t first, std::size_t end) const {
  if (end - first < 2 * kLinePointsMin) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  std::size_t bend = first;
  for (std::size_t i = first + kLinePointsMin; i + kLinePointsMin <= end; ++i) {
    const double of_two = range_fitter_.misfit(first, i - 1) + range_fitter_.misfit(i, end - 1);
    if (of_two >= least) continue;
    least = of_two;
    bend = i;
  }
  const double variance = std::max(square(kSigmaMin_px), least / static_cast<double>(end - first - 4));
  if (range_fitter_.misfit(first, end - 1) - least < kBendMin * variance) return std::nullopt;
  return bend;
}

/// Fits the line to all its points.
void FloorLineFitter::take(const Run& run) {
  double n = 0, columns = 0, rows = 0, contrast = 0;
  for (std::size_t i = run.first; i < run.end; ++i) {
    taken_[i] = 1;
    const BoundaryPoint& point = (*points_)[i];
    if (!run.has(point)) continue;
    n += 1;
    columns += point.column;
    rows += point.row;
    contrast += point.contrast;
  }
  const double mean_column = columns / n, mean_row = rows / n;
  double spread = 0, product = 0, square = 0;
  for (std::size_t i = run.first; i < run.end; ++i) {
    const BoundaryPoint& point = (*points_)[i];
    if (!run.has(point)) continue;
    const double column = point.column - mean_column, row = point.row - mean_row;
    spread += column * column;
    product += column * row;
    square += row * row;
  }
  FloorLine line;
  line.first_column = (*points_)[run.first].column;
  line.last_column = (*points_)[run.end - 1].column;
  line.slope = product / spread;
  line.row_middle = mean_row + line.slope * (line.middle() - mean_column);
  const double variance = std::max(0.0, square - line.slope * product) / (n - 2);
  const double sigma = std::max(kSigmaMin_px, std::sqrt(variance));
  line.sigma_row = sigma / std::sqrt(n);
  line.sigma_slope = sigma / std::sqrt(spread);
  line.contrast = contrast / n;
  lines_.push_back(line);
}

}  // namespace aisle
