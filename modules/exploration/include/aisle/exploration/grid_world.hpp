#pragma once
/// Worlds of square cells with walls on the cells' edges (C97 section 2.3).

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aisle {

/// A side of a cell, in the order of C97's Tables 1 and 3. Left is -x, bottom is -y.
enum class Side : std::uint8_t { kLeft, kRight, kBottom, kTop };

inline constexpr Side kAllSides[] = {Side::kLeft, Side::kRight, Side::kBottom, Side::kTop};

constexpr Side opposite(Side side) {
  return static_cast<Side>(static_cast<std::uint8_t>(side) ^ 1U);
}

/// A set of sides, one bit each.
using Sides = std::uint8_t;

inline constexpr Sides kNoSides = 0;
inline constexpr Sides kEverySide = 15;

constexpr Sides bit(Side side) {
  return static_cast<Sides>(1U << static_cast<unsigned>(side));
}
constexpr bool contains(Sides sides, Side side) {
  return (sides & bit(side)) != 0;
}
constexpr Sides without(Sides sides, Sides others) {
  return static_cast<Sides>(sides & ~others);
}

/// A cell's column and row; (0, 0) is the bottom left one.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

/// The cell on that side of `cell`; it may lie outside the world.
Cell neighbour(Cell cell, Side side);

/// How many cells there are and how they are numbered: row by row from the bottom left.
class GridShape {
 public:
  static constexpr int kMaxSize = 4096;

  /// @param width, height  1 .. kMaxSize; anything else throws std::invalid_argument
  GridShape(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

  bool contains(Cell cell) const { return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_; }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  Cell cell(std::size_t index) const;
  /// The cell on that side, which must exist.
  std::size_t neighbour(std::size_t index, Side side) const {
    return index + steps_[static_cast<unsigned>(side)];
  }

 private:
  int width_;
  int height_;
  std::size_t steps_[4];  ///< from a cell's index to its neighbour's; unsigned arithmetic wraps as wanted
};

/// Which sides of each cell are open. The outer sides are always walls, and both cells of an edge agree about
/// it.
class GridWorld : public GridShape {
 public:
  /// All sides closed.
  GridWorld(int width, int height) : GridShape(width, height), open_(size(), kNoSides) {}

  Sides open(std::size_t index) const { return open_[index]; }
  Sides open(Cell cell) const { return open_[index(cell)]; }

  /// Opens or closes the edge between two cells. An outer side throws std::invalid_argument.
  void set_open(Cell cell, Side side, bool open);
  /// Opens every edge that is not an outer one.
  void open_all();

  Cell start;
  std::vector<Cell> goals;

 private:
  std::vector<Sides> open_;
};

/// What a vehicle has seen of a world: the sides of the cells that it visited.
class LearnedGrid : public GridShape {
 public:
  LearnedGrid(int width, int height) : GridShape(width, height), cells_(size(), 0) {}

  bool visited(std::size_t index) const { return (cells_[index] & kVisited) != 0; }
  /// Open sides; none if the cell was not visited.
  Sides open(std::size_t index) const { return cells_[index] & kEverySide; }
  void see(std::size_t index, Sides open) { cells_[index] = kVisited | open; }

 private:
  static constexpr std::uint8_t kVisited = 16;

  std::vector<std::uint8_t> cells_;
};

/// The cells that can be reached from `start`.
std::vector<bool> reachable_cells(const GridWorld& world, Cell start);

}  // namespace aisle
