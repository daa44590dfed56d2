#include "aisle/formats/mazes/maze_file.hpp"

#include <algorithm>
#include <utility>

#include "aisle/formats/images/portable_bitmap.hpp"
#include "aisle/formats/whole_file.hpp"
#include "mazes/maze_binary.hpp"
#include "mazes/maze_number.hpp"
#include "mazes/maze_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

/// Whether there are control characters that a text cannot contain.
bool is_binary(std::string_view bytes) {
  return std::any_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < '\t' || (byte > '\r' && byte < ' ');
  });
}

MazeFormat format_of(std::string_view bytes) {
  if (bytes.starts_with("P1") || bytes.starts_with("P4")) return MazeFormat::kBitmap;
  if (is_binary(bytes)) return MazeFormat::kBinary;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool begins_with_digit =
      first != std::string_view::npos && bytes[first] >= '0' && bytes[first] <= '9';
  return begins_with_digit ? MazeFormat::kNumber : MazeFormat::kText;
}

Result<MazeFile> parse_bitmap(std::string_view bytes, const std::string& name) {
  const auto bitmap = parse_pbm(bytes, name, GridShape::kMaxSize);
  if (!bitmap) return bitmap.problems();
  const auto first_free = std::find(bitmap->black.rbegin(), bitmap->black.rend(), false);
  if (first_free == bitmap->black.rend())
    return Problem{{name}, "has no white pixel: there is no cell to be in"};

  GridWorld world(bitmap->width, bitmap->height);
  const auto is_free = [&](int x, int y) { return !bitmap->is_black(x, world.height() - 1 - y); };
  for (int y = 0; y < world.height(); ++y) {
    for (int x = 0; x < world.width(); ++x) {
      if (!is_free(x, y)) continue;
      if (x + 1 < world.width() && is_free(x + 1, y)) world.set_open({x, y}, Side::kRight, true);
      if (y + 1 < world.height() && is_free(x, y + 1)) world.set_open({x, y}, Side::kTop, true);
    }
  }
  while (!is_free(world.start.x, world.start.y)) {
    world.start.x = (world.start.x + 1) % world.width();
    world.start.y += world.start.x == 0;
  }
  return MazeFile{std::move(world), MazeFormat::kBitmap, false};
}

}  // namespace

Result<MazeFile> parse_maze(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) return Problem{{name}, "is empty"};
  switch (format_of(bytes)) {
    case MazeFormat::kText:
      return parse_maze_text(bytes, name);
    case MazeFormat::kNumber:
      return parse_maze_number(bytes, name);
    case MazeFormat::kBinary:
      return parse_maze_binary(bytes, name);
    case MazeFormat::kBitmap:
      return parse_bitmap(bytes, name);
  }
  return Problem{{name}, "is not a maze"};
}

Result<MazeFile> read_maze(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_whole_file(path, kMaxBytes);
  if (!bytes) return bytes.problems();
  return parse_maze(*bytes, path.string());
}

}  // namespace aisle
