#include "floor_lines.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace aisle {

namespace {

constexpr double kOffLine_px = 1;  // rows; a point off a line by more is not on it
constexpr double kGap = 4;         // columns without a point that a line may have
constexpr std::size_t kPointsMin = 5;
constexpr std::size_t kLinesMax = 12;
constexpr double kSigmaMin_px = 0.25;  // of a point's row

}  // namespace

const std::vector<FloorLine>& FloorLineFitter::fit(const std::vector<BoundaryPoint>& points,
                                                   double rows_per_column) {
  points_ = &points;
  rows_per_column_ = rows_per_column;
  taken_.assign(points.size(), 0);
  lines_.clear();
  while (lines_.size() < kLinesMax) {
    Run best;
    for (std::size_t a = 0; a < points.size(); a += 2) {
      for (const std::size_t apart : {4, 10, 24}) {
        if (a + apart >= points.size()) break;
        const Run run = grown(a, a + apart);
        if (run.count > best.count) best = run;
      }
    }
    if (best.count < kPointsMin) break;
    take(best);
  }
  std::sort(lines_.begin(), lines_.end(),
            [](const FloorLine& a, const FloorLine& b) { return a.first_column < b.first_column; });
  return lines_;
}

bool FloorLineFitter::is_on(const BoundaryPoint& point, const Run& run) const {
  const double steepness = std::hypot(1.0, run.slope / rows_per_column_);
  return std::abs(point.row - run.row - run.slope * point.column) < kOffLine_px * steepness;
}

/// The line through two points as far as further points lie on it.
FloorLineFitter::Run FloorLineFitter::grown(std::size_t a, std::size_t b) const {
  const auto& points = *points_;
  Run run;
  if (taken_[a] != 0 || taken_[b] != 0) return run;
  run.slope = (points[b].row - points[a].row) / (points[b].column - points[a].column);
  run.row = points[a].row - run.slope * points[a].column;
  run.first = run.end = a;
  double column = points[a].column;
  for (std::size_t i = a; i < points.size() && points[i].column - column <= kGap; ++i) {
    if (taken_[i] != 0) break;
    if (!is_on(points[i], run)) continue;
    column = points[i].column;
    run.end = i + 1;
    ++run.count;
  }
  column = points[a].column;
  for (std::size_t i = a; i-- > 0 && column - points[i].column <= kGap;) {
    if (taken_[i] != 0) break;
    if (!is_on(points[i], run)) continue;
    column = points[i].column;
    run.first = i;
    ++run.count;
  }
  return run;
}

/// Fits the line to all its points.
void FloorLineFitter::take(const Run& run) {
  double n = 0, columns = 0, rows = 0, contrast = 0;
  for (std::size_t i = run.first; i < run.end; ++i) {
    taken_[i] = 1;
    const BoundaryPoint& point = (*points_)[i];
    if (!is_on(point, run)) continue;
    n += 1;
    columns += point.column;
    rows += point.row;
    contrast += point.contrast;
  }
  const double mean_column = columns / n, mean_row = rows / n;
  double spread = 0, product = 0, square = 0;
  for (std::size_t i = run.first; i < run.end; ++i) {
    const BoundaryPoint& point = (*points_)[i];
    if (!is_on(point, run)) continue;
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
