#include "lines/edge_bands.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr std::size_t kSlopeReach = 2;  // of the derivative, to either side
constexpr float kSlopeOfStep = 3;       // the derivative's greatest value at a step of one grey level

/// Rows v .. v + rows - 1 of each column added up.
__attribute__((target_clones("avx2", "default"))) void add_row(const std::uint8_t* row, std::size_t width,
                                                               std::int16_t* sums) {
  for (std::size_t u = 0; u < width; ++u) sums[u] = static_cast<std::int16_t>(sums[u] + row[u]);
}

/// With these weights the parabola through the three greatest values has its peak exactly at an ideal step,
/// wherever in a pixel it is.
__attribute__((target_clones("avx2", "default"))) void differentiate(const std::int16_t* sums,
                                                                     std::size_t width,
                                                                     std::int16_t* slopes) {
  for (std::size_t u = kSlopeReach; u + kSlopeReach < width; ++u) {
    slopes[u] = static_cast<std::int16_t>(2 * (sums[u + 1] - sums[u - 1]) + (sums[u + 2] - sums[u - 2]));
  }
}

std::size_t nearest_column(const EdgePoint& edge) {
  return static_cast<std::size_t>(std::floor(edge.u_px + 0.5F));
}

/// Offset of the peak of the parabola through three values, the middle one being the greatest.
float peak_offset(int before, int middle, int after) {
  return 0.5F * static_cast<float>(before - after) / static_cast<float>(before - 2 * middle + after);
}

}  // namespace

void EdgeBand::find(const Image& grey, int first_row, int rows, float contrast_min) {
  forget();
  sum_rows(grey, first_row, rows);
  differentiate();
  const float per_level = kSlopeOfStep * static_cast<float>(rows);
  const int least = static_cast<int>(std::lround(contrast_min * per_level));
  const float v_px = static_cast<float>(first_row) + 0.5F * static_cast<float>(rows - 1);
  const std::int16_t* d = slopes_.data();
  for (std::size_t u = kSlopeReach + 1; u + kSlopeReach + 1 < slopes_.size(); ++u) {
    const int slope = std::abs(d[u]);
    if (slope < least) continue;
    const int sign = d[u] > 0 ? 1 : -1;
    const int before = sign * d[u - 1], after = sign * d[u + 1];
    if (slope <= before || slope < after) continue;
    const float u_px = static_cast<float>(u) + peak_offset(before, slope, after);
    add(sign > 0 ? Step::kBrighter : Step::kDarker, {u_px, v_px, static_cast<float>(slope) / per_level});
  }
}

void EdgeBand::forget() {
  for (const Step step : kBothSteps) {
    const auto side = static_cast<std::size_t>(step);
    for (const EdgePoint& edge : edges_[side]) edge_at_[side][nearest_column(edge)] = -1;
    edges_[side].clear();
  }
}

void EdgeBand::sum_rows(const Image& grey, int first_row, int rows) {
  const auto width = static_cast<std::size_t>(grey.width_px);
  if (sums_.size() != width) {
    slopes_.assign(width, 0);
    for (auto& columns : edge_at_) columns.assign(width, -1);
  }
  sums_.assign(width, 0);
  for (int v = first_row; v < first_row + rows; ++v) add_row(grey.row(v), width, sums_.data());
}

void EdgeBand::differentiate() {
  aisle::differentiate(sums_.data(), sums_.size(), slopes_.data());
}

void EdgeBand::add(Step step, const EdgePoint& edge) {
  const auto side = static_cast<std::size_t>(step);
  edge_at_[side][nearest_column(edge)] = static_cast<int>(edges_[side].size());
  edges_[side].push_back(edge);
}

}  // namespace aisle
