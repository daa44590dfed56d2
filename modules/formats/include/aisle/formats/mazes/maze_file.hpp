#pragma once
/// Mazes: grid worlds with walls on the cells' edges, in the file formats of micromouse competitions; see
/// docs/formats/maze.md.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/exploration/grid_world.hpp"

namespace aisle {

enum class MazeFormat {
  kText,    ///< drawn in text: 2 H + 1 lines of 4 W + 1 characters
  kNumber,  ///< mms' "num": a line "x y north east south west" for each cell
  kBinary,  ///< .maz: one byte per cell
  kBitmap,  ///< PBM: white pixels are cells, black ones solid
};

struct MazeFile {
  GridWorld world;
  MazeFormat format = MazeFormat::kText;
  bool has_start = false;  ///< false: none in the file; `world.start` is the bottom left free cell
};

/// Plain or gzip; the format is recognised from the content. Every problem has its line and column; after 20
/// problems the rest is only counted.
Result<MazeFile> read_maze(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<MazeFile> parse_maze(std::string_view bytes, const std::string& name);

/// The world drawn in text, with its start and goals; reading it gives the same world.
std::string maze_text(const GridWorld& world);

}  // namespace aisle
