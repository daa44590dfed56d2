#include "mazes/maze_binary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mazes/maze_cells.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr Side kSideOfBit[] = {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft};

Sides walls_of(char byte) {
  Sides walls = kNoSides;
  for (unsigned i = 0; i < 4; ++i) {
    if (static_cast<unsigned char>(byte) >> i & 1) walls |= bit(kSideOfBit[i]);
  }
  return walls;
}

}  // namespace

Result<MazeFile> parse_maze_binary(std::string_view bytes, const std::string& name) {
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(bytes.size()))));
  if (size * size != bytes.size() || size > GridShape::kMaxSize) {
    return Problem{{name},
                   fmt::format("is binary and {} bytes long; a binary maze has N x N bytes, N up to {}",
                               bytes.size(), GridShape::kMaxSize)};
  }
  MazeCells cells(static_cast<int>(size), static_cast<int>(size));
  const auto cell_at = [size](std::size_t byte) {
    return Cell{static_cast<int>(byte / size), static_cast<int>(byte % size)};
  };
  for (std::size_t i = 0; i < bytes.size(); ++i) cells.walls(cell_at(i)) = walls_of(bytes[i]);
  ProblemList problems(name);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    cells.check(cell_at(i),
                [&](const std::string& what) { problems.add(0, fmt::format("byte {}", i + 1), what); });
  }
  if (!problems.empty()) return problems.take();
  return MazeFile{cells.world(), MazeFormat::kBinary, false};
}

}  // namespace aisle
