#include "route/region_growth.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

constexpr double kDecline = 1.2;  // power by which floor gets less likely with the distance

Vec2 colour_of(const CellLook& look) {
  return Vec2(look.red_green, look.yellow_blue);
}

Cost cost_of(double grey_levels) {
  return static_cast<Cost>(kLookUnit * grey_levels);
}

}  // namespace

void RegionGrowth::grow(const Image& image) {
  const int columns = grid_.columns, rows = grid_.rows;
  grid_.take(image, params_.columns);
  if (grid_.columns != columns || grid_.rows != rows) expect();
  steps_.take(grid_, params_.colour_weight, quiet_step());
  floor_ = expected_floor_;
  steps_.spread(floor_);
  // Never where the floor continues without a step.
  rest_ = expected_rest_;
  for (std::size_t i = 0; i < rest_.size(); ++i)
    if (floor_[i] <= params_.alike_cost * kLookUnit) rest_[i] = kNoPath;
  steps_.spread(rest_);
  find_unmatched();
  is_floor_.resize(floor_.size());
  for (std::size_t i = 0; i < floor_.size(); ++i)
    is_floor_[i] = static_cast<char>(floor_[i] < rest_[i] && is_unmatched_[i] == 0);
  connect();
}

/// Costs of floor and rest by the place in the image alone.
void RegionGrowth::expect() {
  find_patch();
  expected_floor_.resize(grid_.looks.size());
  expected_rest_.resize(grid_.looks.size());
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      expected_floor_[grid_.index(row, column)] = cost_of(expected_floor(row, column));
      expected_rest_[grid_.index(row, column)] = cost_of(expected_rest(row, column));
    }
  }
}

/// The middle of the lower edge, which is floor.
void RegionGrowth::find_patch() {
  const double horizon_rows = (1 - params_.horizon_share) * grid_.rows;
  const int rows = std::clamp(static_cast<int>(params_.near_reach * horizon_rows), 1, grid_.rows);
  const int half = std::max(1, static_cast<int>(params_.near_reach * grid_.columns / 2));
  const int first = std::max(0, grid_.columns / 2 - half);
  patch_ = {grid_.rows - rows, grid_.rows, first, grid_.columns - first};
}

/// The route's look (L96 section 2.2), of a patch of the image itself.
CellLook RegionGrowth::patch_look() {
  const auto median_of = [&](int CellLook::*part) {
    looks_.clear();
    for (int row = patch_.first_row; row < patch_.end_row; ++row)
      for (int column = patch_.first_column; column < patch_.end_column; ++column)
        looks_.push_back(grid_.looks[grid_.index(row, column)].*part);
    return median_reordering(std::span(looks_));
  };
  return {median_of(&CellLook::brightness), median_of(&CellLook::red_green),
          median_of(&CellLook::yellow_blue)};
}

Cost RegionGrowth::quiet_step() {
  const double texture = params_.texture_factor * steps_.texture_of(grid_, patch_, params_.colour_weight);
  return static_cast<Cost>(
      std::max(params_.quiet_step * kLookUnit, std::min(texture, params_.texture_max * kLookUnit)));
}

/// Distance from the middle column: 0 in the middle, 1 at the sides.
double RegionGrowth::lateral(int column) const {
  return std::abs(2 * column + 1 - grid_.columns) / static_cast<double>(grid_.columns);
}

/// 0 near the middle of the lower edge; `floor_cost` at the horizon above it and in the lower corners.
double RegionGrowth::expected_floor(int row, int column) const {
  const double horizon_rows = (1 - params_.horizon_share) * grid_.rows;
  const double away = (grid_.rows - 1 - row) / horizon_rows + lateral(column) - params_.near_reach;
  if (away <= 0 || patch_.contains(row, column)) return 0;
  return params_.floor_cost * std::pow(away, kDecline);
}

/// 0 in the upper part, growing below.
double RegionGrowth::expected_rest(int row, int column) const {
  const double below = (row + 0.5) / grid_.rows - params_.far_share - params_.side_share * lateral(column);
  return params_.rest_cost * std::max(0.0, below);
}

/// Marks cells of another colour than the route. Gloss and shadow only make its colour paler.
void RegionGrowth::find_unmatched() {
  const Vec2 route = colour_of(patch_look());
  const double limit = params_.unmatched_colour * kLookUnit;
  is_unmatched_.resize(grid_.looks.size());
  for (std::size_t i = 0; i < is_unmatched_.size(); ++i) {
    const Vec2 colour = colour_of(grid_.looks[i]);
    const double paleness = std::clamp(colour.dot(route) / std::max(route.squaredNorm(), 1.0), 0.0, 1.0);
    is_unmatched_[i] = static_cast<char>((colour - paleness * route).norm() > limit);
  }
}

/// The cells of floor that are connected to the patch.
void RegionGrowth::connect() {
  is_region_.assign(is_floor_.size(), 0);
  for (int row = patch_.first_row; row < grid_.rows; ++row)
    for (int column = patch_.first_column; column < patch_.end_column; ++column)
      reach(grid_.index(row, column));
  const auto columns = static_cast<std::size_t>(grid_.columns);
  while (!open_.empty()) {
    const std::size_t i = open_.back();
    open_.pop_back();
    if (i % columns > 0) reach(i - 1);
    if (i % columns + 1 < columns) reach(i + 1);
    if (i >= columns) reach(i - columns);
    if (i + columns < is_floor_.size()) reach(i + columns);
  }
}

void RegionGrowth::reach(std::size_t cell) {
  if (is_floor_[cell] == 0 || is_region_[cell] != 0) return;
  is_region_[cell] = 1;
  open_.push_back(cell);
}

}  // namespace aisle
