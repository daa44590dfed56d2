#include "aisle/vision/route_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_grid.hpp"

namespace aisle {

void RegionParams::describe(FieldList& fields) {
  fields.count("columns", columns, {20, 2000}, "cells that the picture is looked at in, from left to right");
  fields.real("patch_share", patch_share, {0.02, 1},
              "side of the patch that tells the route's look, of the width");
  fields.real("quiet_step", quiet_step, {0, 50}, "grey levels between neighbouring cells that are no edge");
  fields.real("colour_weight", colour_weight, {0, 20}, "of a step of colour against one of brightness");
  fields.real("look_weight", look_weight, {0, 1}, "cost of a cell for each grey level off the patch's look");
  fields.real("far_share", far_share, {0, 1},
              "of the height, from the top: starts the rest unless it is floor");
  fields.real("far_cost", far_cost, {0, 255}, "grey levels of steps below which even the top is floor");
  fields.real("strange_colour", strange_colour, {1, 500}, "grey levels off the route's colour: an obstacle");
}

namespace {

using Cost = int;  ///< in sixteenths of a grey level
constexpr Cost kNever = std::numeric_limits<Cost>::max() / 4;

class Growth {
 public:
  Growth(const CellGrid& grid, const RegionParams& params) : grid_(grid) {
    const auto n = grid.looks.size();
    right_.resize(n);
    down_.resize(n);
    const Cost quiet = static_cast<Cost>(params.quiet_step * kLookUnit);
    const auto step = [&](const CellLook& a, const CellLook& b) {
      const double l = a.brightness - b.brightness;
      const double c1 = params.colour_weight * (a.red_green - b.red_green);
      const double c2 = params.colour_weight * (a.yellow_blue - b.yellow_blue);
      const int d = static_cast<int>(std::sqrt(l * l + c1 * c1 + c2 * c2));
      return 1 + std::max(0, d - quiet);
    };
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        const auto i = grid.index(r, c);
        right_[i] = c + 1 < grid.columns ? step(grid.looks[i], grid.looks[i + 1]) : kNever;
        down_[i] = r + 1 < grid.rows ? step(grid.looks[i], grid.looks[grid.index(r + 1, c)]) : kNever;
      }
  }

  void grow(std::vector<Cost>& cost, const std::vector<Cost>& own) const {
    const auto relax = [&](std::size_t at, std::size_t from, Cost step) {
      const Cost through = cost[from] + step + own[at];
      if (through >= cost[at]) return false;
      cost[at] = through;
      return true;
    };
    bool changed = true;
    while (changed) {
      changed = false;
      for (int r = 0; r < grid_.rows; ++r) {
        for (int c = 0; c < grid_.columns; ++c) {
          const auto i = grid_.index(r, c);
          if (r > 0)
            changed |= relax(i, i - static_cast<std::size_t>(grid_.columns),
                             down_[i - static_cast<std::size_t>(grid_.columns)]);
          if (c > 0) changed |= relax(i, i - 1, right_[i - 1]);
        }
        for (int c = grid_.columns - 2; c >= 0; --c) {
          const auto i = grid_.index(r, c);
          changed |= relax(i, i + 1, right_[i]);
        }
      }
      for (int r = grid_.rows - 1; r >= 0; --r) {
        for (int c = 0; c < grid_.columns; ++c) {
          const auto i = grid_.index(r, c);
          if (r + 1 < grid_.rows) changed |= relax(i, i + static_cast<std::size_t>(grid_.columns), down_[i]);
          if (c > 0) changed |= relax(i, i - 1, right_[i - 1]);
        }
        for (int c = grid_.columns - 2; c >= 0; --c) {
          const auto i = grid_.index(r, c);
          changed |= relax(i, i + 1, right_[i]);
        }
      }
    }
  }

 private:
  const CellGrid& grid_;
  std::vector<Cost> right_, down_;
};

}  // namespace

RouteRegion find_route_region(const Image& picture, const RegionParams& params) {
  RouteRegion region;
  if (picture.bytes.empty()) return region;
  region.mask = Image(picture.width_px, picture.height_px);
  const CellGrid grid = cells_of(picture, params.columns);
  const int side =
      std::clamp(static_cast<int>(params.patch_share * grid.columns), 1, std::min(grid.columns, grid.rows));
  const int left = (grid.columns - side) / 2;
  // look of the patch: medians
  std::vector<int> l, a, b;
  for (int r = grid.rows - side; r < grid.rows; ++r)
    for (int c = left; c < left + side; ++c) {
      const auto& k = grid.looks[grid.index(r, c)];
      l.push_back(k.brightness);
      a.push_back(k.red_green);
      b.push_back(k.yellow_blue);
    }
  const auto med = [](std::vector<int>& v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
  };
  const CellLook look{med(l), med(a), med(b)};
  const auto off = [&](const CellLook& k) {
    const double dl = k.brightness - look.brightness;
    const double c1 = params.colour_weight * (k.red_green - look.red_green);
    const double c2 = params.colour_weight * (k.yellow_blue - look.yellow_blue);
    return std::sqrt(dl * dl + c1 * c1 + c2 * c2);
  };
  const Growth growth(grid, params);
  std::vector<Cost> own(grid.looks.size()), none(grid.looks.size(), 0);
  for (std::size_t i = 0; i < own.size(); ++i)
    own[i] = static_cast<Cost>(params.look_weight * off(grid.looks[i]));
  std::vector<Cost> floor(grid.looks.size(), kNever), rest(grid.looks.size(), kNever);
  for (int r = grid.rows - side; r < grid.rows; ++r)
    for (int c = left; c < left + side; ++c) floor[grid.index(r, c)] = own[grid.index(r, c)];
  growth.grow(floor, own);
  const int far_rows = static_cast<int>(params.far_share * grid.rows);
  for (int r = 0; r < far_rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      if (floor[grid.index(r, c)] > params.far_cost * kLookUnit) rest[grid.index(r, c)] = 0;
  growth.grow(rest, none);
  std::size_t count = 0;
  for (int v = 0; v < picture.height_px; ++v)
    for (int u = 0; u < picture.width_px; ++u) {
      const auto i = grid.index(v / grid.cell_px, u / grid.cell_px);
      const bool on = floor[i] < rest[i];
      region.mask.row(v)[u] = on ? 255 : 0;
      count += on;
    }
  region.share = static_cast<double>(count) / static_cast<double>(region.mask.bytes.size());
  return region;
}

namespace {

/// The middle of the widest unbroken part of the region in one row.
std::optional<Vec2> middle_of_row(const Image& mask, int row) {
  std::optional<Vec2> middle;
  int widest = 0;
  for (int u = 0; u < mask.width_px; ++u) {
    int end = u;
    while (end < mask.width_px && mask.row(row)[end] != 0) ++end;
    if (end - u > widest) {
      widest = end - u;
      middle = Vec2((u + end - 1) / 2.0, row);
    }
    u = end;
  }
  return middle;
}

}  // namespace

std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row) {
  const auto far = middle_of_row(mask, far_row), near = middle_of_row(mask, near_row);
  if (!far || !near) return std::nullopt;
  return RouteMiddle{*far, *near, (*far + *near) / 2};
}

}  // namespace aisle
