#include "aisle/exploration/grid_world.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace aisle {

Cell neighbour(Cell cell, Side side) {
  switch (side) {
    case Side::kLeft:
      return {cell.x - 1, cell.y};
    case Side::kRight:
      return {cell.x + 1, cell.y};
    case Side::kBottom:
      return {cell.x, cell.y - 1};
    case Side::kTop:
      return {cell.x, cell.y + 1};
  }
  return cell;
}

GridShape::GridShape(int width, int height) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > kMaxSize || height > kMaxSize) {
    throw std::invalid_argument("a grid of " + std::to_string(width) + " x " + std::to_string(height) +
                                " cells");
  }
  const auto row = static_cast<std::size_t>(width);
  steps_[static_cast<unsigned>(Side::kLeft)] = ~std::size_t{0};
  steps_[static_cast<unsigned>(Side::kRight)] = 1;
  steps_[static_cast<unsigned>(Side::kBottom)] = ~row + 1;
  steps_[static_cast<unsigned>(Side::kTop)] = row;
}

Cell GridShape::cell(std::size_t index) const {
  const auto row = static_cast<std::size_t>(width_);
  return {static_cast<int>(index % row), static_cast<int>(index / row)};
}

void GridWorld::set_open(Cell cell, Side side, bool open) {
  const Cell other = aisle::neighbour(cell, side);
  if (!contains(cell) || !contains(other)) {
    throw std::invalid_argument("GridWorld::set_open: (" + std::to_string(cell.x) + ", " +
                                std::to_string(cell.y) + ") has no neighbour there");
  }
  Sides& here = open_[index(cell)];
  Sides& there = open_[index(other)];
  here = open ? here | bit(side) : without(here, bit(side));
  there = open ? there | bit(opposite(side)) : without(there, bit(opposite(side)));
}

void GridWorld::open_all() {
  std::fill(open_.begin(), open_.end(), kEverySide);
  for (int x = 0; x < width(); ++x) {
    open_[index({x, 0})] &= without(kEverySide, bit(Side::kBottom));
    open_[index({x, height() - 1})] &= without(kEverySide, bit(Side::kTop));
  }
  for (int y = 0; y < height(); ++y) {
    open_[index({0, y})] &= without(kEverySide, bit(Side::kLeft));
    open_[index({width() - 1, y})] &= without(kEverySide, bit(Side::kRight));
  }
}

std::vector<bool> reachable_cells(const GridWorld& world, Cell start) {
  std::vector<bool> reached(world.size(), false);
  std::vector<std::uint32_t> waiting{static_cast<std::uint32_t>(world.index(start))};
  reached[waiting.back()] = true;
  while (!waiting.empty()) {
    const std::size_t cell = waiting.back();
    waiting.pop_back();
    for (const Side side : kAllSides) {
      if (!contains(world.open(cell), side)) continue;
      const std::size_t next = world.neighbour(cell, side);
      if (reached[next]) continue;
      reached[next] = true;
      waiting.push_back(static_cast<std::uint32_t>(next));
    }
  }
  return reached;
}

}  // namespace aisle
