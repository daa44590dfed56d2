#include "route/region_growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/median.hpp"
#include "route/step_costs.hpp"

namespace aisle {

namespace {

constexpr double kDecline = 1.2;  // power by which floor is expected the less, the farther away

/// The lowest middle, which is floor.
CellBlock patch_in_front(const CellGrid& grid, const RegionParams& params) {
  const double horizon_rows = (1 - params.horizon_share) * grid.rows;
  const int rows = std::clamp(static_cast<int>(params.near_reach * horizon_rows), 1, grid.rows);
  const int half = std::max(1, static_cast<int>(params.near_reach * grid.columns / 2));
  const int first = std::max(0, grid.columns / 2 - half);
  return {grid.rows - rows, grid.rows, first, grid.columns - first};
}

/// The route's look (L96 section 2.2), of a patch of the picture itself.
CellLook look_of(const CellBlock& patch, const CellGrid& grid) {
  std::vector<int> brightness, red_green, yellow_blue;
  for (int row = patch.first_row; row < patch.end_row; ++row) {
    for (int column = patch.first_column; column < patch.end_column; ++column) {
      const CellLook& look = grid.looks[grid.index(row, column)];
      brightness.push_back(look.brightness);
      red_green.push_back(look.red_green);
      yellow_blue.push_back(look.yellow_blue);
    }
  }
  return {median(std::move(brightness)), median(std::move(red_green)), median(std::move(yellow_blue))};
}

Vec2 colour_of(const CellLook& look) {
  return Vec2(look.red_green, look.yellow_blue);
}

class RegionGrowth {
 public:
  RegionGrowth(const CellGrid& grid, const RegionParams& params)
      : grid_(grid),
        params_(params),
        patch_(patch_in_front(grid, params)),
        steps_(grid, params.colour_weight, quiet_step()) {}

  /// For each cell: is it of the region?
  std::vector<char> region() const {
    std::vector<Cost> floor = expected_floor();
    steps_.spread(floor);
    std::vector<Cost> rest = expected_rest(floor);
    steps_.spread(rest);
    const std::vector<char> is_strange = strange_cells();
    std::vector<char> is_floor(floor.size());
    for (std::size_t i = 0; i < floor.size(); ++i)
      is_floor[i] = static_cast<char>(floor[i] < rest[i] && is_strange[i] == 0);
    return connected(is_floor);
  }

 private:
  Cost quiet_step() const {
    const double texture = params_.texture_factor * texture_of(grid_, patch_, params_.colour_weight);
    return static_cast<Cost>(
        std::max(params_.quiet_step * kLookUnit, std::min(texture, params_.texture_max * kLookUnit)));
  }

  /// 0 in the middle, 1 at the sides.
  double aside(int column) const {
    return std::abs(2 * column + 1 - grid_.columns) / static_cast<double>(grid_.columns);
  }

  template <class Expect>
  std::vector<Cost> for_each_cell(Expect expect) const {
    std::vector<Cost> costs(grid_.looks.size());
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        costs[grid_.index(row, column)] = static_cast<Cost>(kLookUnit * expect(row, column));
    return costs;
  }

  /// Nothing near the lowest middle; `floor_cost` at the horizon above it and in the lower corners.
  std::vector<Cost> expected_floor() const {
    const double horizon_rows = (1 - params_.horizon_share) * grid_.rows;
    return for_each_cell([&](int row, int column) {
      const double way = (grid_.rows - 1 - row) / horizon_rows + aside(column) - params_.near_reach;
      if (way <= 0 || patch_.contains(row, column)) return 0.0;
      return params_.floor_cost * std::pow(way, kDecline);
    });
  }

  /// Nothing in the upper part, more and more below; never where the floor goes on without a step.
  std::vector<Cost> expected_rest(const std::vector<Cost>& floor) const {
    std::vector<Cost> rest = for_each_cell([&](int row, int column) {
      const double below = (row + 0.5) / grid_.rows - params_.far_share - params_.side_share * aside(column);
      return params_.rest_cost * std::max(0.0, below);
    });
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (floor[i] <= params_.alike_cost * kLookUnit) rest[i] = kNoWay;
    return rest;
  }

  /// Of another colour than the route. Gloss and shadow only make its colour paler.
  std::vector<char> strange_cells() const {
    const Vec2 route = colour_of(look_of(patch_, grid_));
    const double limit = params_.strange_colour * kLookUnit;
    std::vector<char> is_strange(grid_.looks.size());
    for (std::size_t i = 0; i < is_strange.size(); ++i) {
      const Vec2 colour = colour_of(grid_.looks[i]);
      const double paleness = std::clamp(colour.dot(route) / std::max(route.squaredNorm(), 1.0), 0.0, 1.0);
      is_strange[i] = static_cast<char>((colour - paleness * route).norm() > limit);
    }
    return is_strange;
  }

  /// The cells that hang together with the patch.
  std::vector<char> connected(const std::vector<char>& is_floor) const {
    std::vector<char> is_reached(is_floor.size(), 0);
    std::vector<std::size_t> open;
    const auto reach = [&](std::size_t i) {
      if (is_floor[i] == 0 || is_reached[i] != 0) return;
      is_reached[i] = 1;
      open.push_back(i);
    };
    for (int row = patch_.first_row; row < grid_.rows; ++row)
      for (int column = patch_.first_column; column < patch_.end_column; ++column)
        reach(grid_.index(row, column));
    const auto columns = static_cast<std::size_t>(grid_.columns);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      if (i % columns > 0) reach(i - 1);
      if (i % columns + 1 < columns) reach(i + 1);
      if (i >= columns) reach(i - columns);
      if (i + columns < is_floor.size()) reach(i + columns);
    }
    return is_reached;
  }

  const CellGrid& grid_;
  const RegionParams& params_;
  CellBlock patch_;
  StepCosts steps_;
};

}  // namespace

std::vector<char> region_cells(const CellGrid& grid, const RegionParams& params) {
  return RegionGrowth(grid, params).region();
}

}  // namespace aisle
