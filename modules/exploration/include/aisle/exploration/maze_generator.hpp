#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/problem.hpp"
#include "aisle/core/random.hpp"
#include "aisle/exploration/grid_world.hpp"

namespace aisle {

enum class MazeKind {
  kPerfect,  ///< a tree: one path between any two cells
  kBraided,  ///< a perfect maze with a share of its dead ends opened, which makes loops
  kRooms,    ///< a perfect maze with rectangular rooms cleared in it
  kSpiral,   ///< one corridor winding to the middle
  kComb,     ///< one corridor along the bottom with teeth of different lengths
  kHall,     ///< no inner wall at all
};

inline constexpr MazeKind kMazeKinds[] = {MazeKind::kPerfect, MazeKind::kBraided, MazeKind::kRooms,
                                          MazeKind::kSpiral,  MazeKind::kComb,    MazeKind::kHall};

std::string_view name_of(MazeKind kind);
std::optional<MazeKind> maze_kind(std::string_view name);

struct MazeRecipe {
  MazeKind kind = MazeKind::kPerfect;
  int width = 16;  ///< 1 .. GridShape::kMaxSize
  int height = 16;
  double loop_share = 0.5;  ///< of the dead ends that kBraided opens, 0 .. 1

  Problems problems() const;
};

/// The same world for the same recipe and seed. It starts at (0, 0); the goals are the middle cells.
GridWorld generate_maze(const MazeRecipe& recipe, Random random);

/// The cells in the middle: one, two or four.
std::vector<Cell> middle_cells(const GridShape& shape);

}  // namespace aisle
