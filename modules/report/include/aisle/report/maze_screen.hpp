#pragma once

#include <string>

#include "aisle/exploration/grid_explorer.hpp"

namespace aisle {

/// A run as text for a terminal: the world and the learned map, the state, the stack and the rules that
/// fired. Colours and underlines are ANSI sequences; every frame begins with the sequence that moves the
/// cursor to the top left corner.
class MazeScreen {
 public:
  /// The run starts at `world.start`. World and rules must outlive the screen.
  MazeScreen(const GridWorld& world, const GridRules& rules);

  /// The size of a frame in the terminal.
  int columns() const;
  int rows() const;

  /// Runs one learning cycle; false: the run is over.
  bool step();
  std::string frame() const;

 private:
  std::string row(int y) const;
  std::string world_cell(Cell cell) const;
  std::string map_cell(Cell cell) const;
  std::string status() const;
  std::string stack_text() const;

  const GridWorld& world_;
  const GridRules& rules_;
  GridExplorer explorer_;
  std::size_t moves_ = 0;
  std::string fired_;  ///< the rules of the latest cycle, one per line
  bool over_ = false;
};

}  // namespace aisle
