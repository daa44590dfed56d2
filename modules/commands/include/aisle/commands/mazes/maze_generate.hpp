#pragma once

#include <cstdint>
#include <filesystem>

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/maze_generator.hpp"

namespace aisle {

struct MazeGenerateOptions {
  MazeRecipe recipe;
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< empty: the maze is the outcome's text
  bool force = false;
};

/// `aisle maze generate`: generates a random maze, as maze text.
Result<Outcome> run_maze_generate(const MazeGenerateOptions& options, Console& console);

}  // namespace aisle
