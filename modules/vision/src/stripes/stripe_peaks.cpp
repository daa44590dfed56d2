#include "stripes/stripe_peaks.hpp"

#include <algorithm>
#include <optional>

namespace aisle {
namespace {

/// One column of an image.
struct Column {
  const Image& image;
  int u;

  int operator[](int v) const { return image.row(v)[u]; }
  int height() const { return image.height_px; }
};

constexpr double kBaseShare = 0.15;  // of the peak: what is fainter may be the surroundings

/// The steepest step between neighbouring rows of [first, last], downwards (+1) or upwards (-1).
int steepest(const Column& column, int first, int last, int sign) {
  int best = 0;
  for (int v = first; v < last; ++v) best = std::max(best, sign * (column[v + 1] - column[v]));
  return best;
}

/// Centroid of what is above the base, over the rows around the peak down to where it ends or rises again.
double centre_row(const Column& column, int peak_row) {
  const double base = kBaseShare * column[peak_row];
  double weights = 0, moment = 0;
  const auto add = [&](int v) {
    const double weight = column[v] - base;
    weights += weight;
    moment += weight * (v - peak_row);
  };
  const auto goes_on = [&](int v, int from) {
    return v >= 0 && v < column.height() && column[v] > base &&
           (column[v] <= column[from] || 2 * column[v] > column[peak_row]);
  };
  add(peak_row);
  for (int v = peak_row - 1; goes_on(v, v + 1); --v) add(v);
  for (int v = peak_row + 1; goes_on(v, v - 1); ++v) add(v);
  return peak_row + moment / weights;
}

/// The run's peak, if it is shaped as a stripe: both flanks steep, not too wide.
std::optional<StripePeak> peak_of_run(const Column& column, int first, int last, const PeakLimits& limits) {
  int peak_row = first;
  for (int v = first; v <= last; ++v)
    if (column[v] > column[peak_row]) peak_row = v;
  const int peak = column[peak_row];
  int top = peak_row, bottom = peak_row;
  while (top > first && 2 * column[top - 1] >= peak) --top;
  while (bottom < last && 2 * column[bottom + 1] >= peak) ++bottom;
  if (bottom - top + 1 > limits.width_max_px) return std::nullopt;
  const double gradient_min = limits.gradient_min * peak;
  const int above = std::max(top - 2, 0), below = std::min(bottom + 2, column.height() - 1);
  if (steepest(column, above, peak_row, +1) < gradient_min) return std::nullopt;
  if (steepest(column, peak_row, below, -1) < gradient_min) return std::nullopt;
  return StripePeak{column.u, centre_row(column, peak_row), static_cast<double>(peak)};
}

}  // namespace

std::vector<StripePeak> find_stripe_peaks(const Image& contrast, const PeakLimits& limits) {
  std::vector<StripePeak> peaks;
  constexpr int kNone = -1;
  std::vector<int> run_start(static_cast<std::size_t>(contrast.width_px), kNone);
  const auto end_run = [&](int u, int end) {
    int& start = run_start[static_cast<std::size_t>(u)];
    if (const auto peak = peak_of_run({contrast, u}, start, end - 1, limits)) peaks.push_back(*peak);
    start = kNone;
  };
  for (int v = 0; v < contrast.height_px; ++v) {
    const std::uint8_t* row = contrast.row(v);
    for (int u = 0; u < contrast.width_px; ++u) {
      const bool inside = row[u] >= limits.contrast_min;
      int& start = run_start[static_cast<std::size_t>(u)];
      if (inside == (start != kNone)) continue;
      if (inside)
        start = v;
      else
        end_run(u, v);
    }
  }
  for (int u = 0; u < contrast.width_px; ++u)
    if (run_start[static_cast<std::size_t>(u)] != kNone) end_run(u, contrast.height_px);
  std::sort(peaks.begin(), peaks.end(), [](const StripePeak& a, const StripePeak& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  });
  return peaks;
}

}  // namespace aisle
