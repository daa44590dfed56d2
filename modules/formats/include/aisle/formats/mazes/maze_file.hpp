#pragma once
/// Worlds of cells with walls on their edges, as people who race mazes keep them. docs/formats/maze.md says
/// what is read.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/exploration/grid_world.hpp"

namespace aisle {

enum class MazeFormat {
  kText,    ///< an image in text: 2 H + 1 lines of 4 W + 1 characters
  kNumber,  ///< mms' "num": a line "x y north east south west" for each cell
  kBinary,  ///< .maz: one byte a cell
  kBitmap,  ///< PBM: white pixels are cells, black ones solid
};

struct MazeFile {
  GridWorld world;
  MazeFormat format = MazeFormat::kText;
  bool has_start =
      false;  ///< false: the file tells none; `world.start` is then the bottom left cell that is free
};

/// Plain or gzip; the format is known from the content. Whatever is wrong is a problem with line and column;
/// after 20 problems the rest is only counted.
Result<MazeFile> read_maze(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in problems.
Result<MazeFile> parse_maze(std::string_view bytes, const std::string& name);

/// The world as an image in text, with its start and goals; reading it gives the same world.
std::string maze_text(const GridWorld& world);

}  // namespace aisle
