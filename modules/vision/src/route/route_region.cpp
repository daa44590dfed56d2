#include "aisle/vision/route/route_region.hpp"

#include <algorithm>

#include "route/region_growth.hpp"

namespace aisle {

void RegionParams::describe(FieldList& fields) {
  fields.count("columns", columns, {16, 1024}, "cells across the image, from left to right");
  fields.real("quiet_step", quiet_step, {0, 50},
              "steps up to this between neighbouring cells are noise and drift, no edge");
  fields.real("texture_factor", texture_factor, {0, 10},
              "nor are steps up to this many times the usual one on the floor in front");
  fields.real("texture_max", texture_max, {0, 100}, "but larger steps than this are always edges");
  fields.real("colour_weight", colour_weight, {0, 20}, "of a step of colour against one of brightness");
  fields.real("unmatched_colour", unmatched_colour, {5, 500},
              "off the colour of the floor in front: an obstacle");
  fields.real("horizon_share", horizon_share, {0, 0.9},
              "where the horizon is expected, of the height from the top");
  fields.real("near_reach", near_reach, {0.01, 1},
              "surely floor, up to this share of the height from the lower edge's middle to the horizon");
  fields.real("floor_cost", floor_cost, {0, 2000}, "of taking a place at the horizon for floor, unconnected");
  fields.real("far_share", far_share, {0, 1}, "of the height, from the top: not floor unless it looks alike");
  fields.real("side_share", side_share, {0, 1}, "by how much lower that reaches at the sides");
  fields.real("rest_cost", rest_cost, {0, 2000}, "of taking a place an image's height lower for not floor");
  fields.real("alike_cost", alike_cost, {0, 500},
              "cells that cost less than this from the lower edge's middle are floor, wherever they are");
}

namespace {

void paint(const RegionGrowth& growth, Image& mask) {
  const CellGrid& grid = growth.grid();
  for (int v = 0; v < mask.height_px; ++v) {
    const char* cells = &growth.region()[grid.index(v / grid.cell_px, 0)];
    for (int u = 0; u < mask.width_px; ++u) mask.row(v)[u] = cells[u / grid.cell_px] != 0 ? 255 : 0;
  }
}

/// The middle of the widest unbroken part of the region in one row.
std::optional<Vec2> middle_of_row(const Image& mask, int row, int begin_column, int end_column) {
  std::optional<Vec2> middle;
  int widest = 0;
  for (int u = begin_column; u < end_column; ++u) {
    int end = u;
    while (end < end_column && mask.row(row)[end] != 0) ++end;
    if (end - u > widest) {
      widest = end - u;
      middle = Vec2((u + end - 1) / 2.0, row);
    }
    u = end;
  }
  return middle;
}

}  // namespace

RouteRegionFinder::RouteRegionFinder(const RegionParams& params)
    : growth_(std::make_unique<RegionGrowth>(params)) {}
RouteRegionFinder::~RouteRegionFinder() = default;
RouteRegionFinder::RouteRegionFinder(RouteRegionFinder&&) noexcept = default;
RouteRegionFinder& RouteRegionFinder::operator=(RouteRegionFinder&&) noexcept = default;

void RouteRegionFinder::find(const Image& image, Image& mask) {
  mask.width_px = image.width_px;
  mask.height_px = image.height_px;
  mask.channels = 1;
  mask.bytes.resize(mask.row_bytes() * mask.rows());
  if (mask.bytes.empty()) return;
  growth_->grow(image);
  paint(*growth_, mask);
}

RouteRegion find_route_region(const Image& image, const RegionParams& params) {
  RouteRegion region;
  RouteRegionFinder(params).find(image, region.mask);
  if (region.mask.bytes.empty()) return region;
  const auto count = std::count(region.mask.bytes.begin(), region.mask.bytes.end(), std::uint8_t{255});
  region.share = static_cast<double>(count) / static_cast<double>(region.mask.bytes.size());
  return region;
}

std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row) {
  return find_route_middle(mask, far_row, near_row, 0, mask.width_px);
}

std::optional<RouteMiddle> find_route_middle(const Image& mask, int far_row, int near_row, int begin_column,
                                             int end_column) {
  const auto far = middle_of_row(mask, far_row, begin_column, end_column);
  const auto near = middle_of_row(mask, near_row, begin_column, end_column);
  if (!far || !near) return std::nullopt;
  return RouteMiddle{*far, *near, (*far + *near) / 2};
}

}  // namespace aisle
