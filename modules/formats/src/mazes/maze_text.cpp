#include "mazes/maze_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "field_reader.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMaxSize = GridShape::kMaxSize;
constexpr std::string_view kLevelWalls = "-_=#";
constexpr std::string_view kUprightWalls = "|!#";
constexpr std::string_view kPosts = "o+.*#|-_ ";

bool is_one_of(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

std::string_view without_line_end(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

class MazeTextParser {
 public:
  explicit MazeTextParser(const std::string& name) : name_(name), problems_(name) {}

  Result<MazeFile> parse(std::string_view text) {
    split(text);
    if (!check_shape()) return problems_.take();
    GridWorld world(width_, height_);
    for (std::size_t row = 0; row < lines_.size(); ++row) {
      if (row % 2 == 0) {
        read_posts_and_level_walls(row, world);
      } else {
        read_cells_and_upright_walls(row, world);
      }
    }
    if (!problems_.empty()) return problems_.take();
    return MazeFile{std::move(world), MazeFormat::kText, has_start_};
  }

 private:
  void split(std::string_view text);
  bool check_shape();
  void read_posts_and_level_walls(std::size_t row, GridWorld& world);
  void read_cells_and_upright_walls(std::size_t row, GridWorld& world);
  bool read_level_wall(std::size_t row, std::size_t column);
  bool read_upright_wall(std::size_t row, std::size_t column);
  void read_cell(std::size_t row, std::size_t column, Cell cell, GridWorld& world);

  void problem(std::size_t row, std::size_t column, std::string what) {
    problems_.add(static_cast<long>(row) + 1, fmt::format("column {}", column + 1), std::move(what));
  }
  void unknown(std::size_t row, std::size_t column, const char* expected) {
    problem(row, column, fmt::format("'{}' where {}", printable(lines_[row].substr(column, 1)), expected));
  }

  std::string name_;
  ProblemList problems_;
  std::vector<std::string_view> lines_;
  int width_ = 0;
  int height_ = 0;
  bool has_start_ = false;
};

void MazeTextParser::split(std::string_view text) {
  while (!text.empty() && lines_.size() <= 2 * kMaxSize + 2)
    lines_.push_back(without_line_end(take_line(text)));
  while (!lines_.empty() && lines_.back().empty()) lines_.pop_back();
}

bool MazeTextParser::check_shape() {
  if (lines_.empty()) {
    problems_.add(0, "has blank lines only");
    return false;
  }
  const std::size_t length = lines_.front().size();
  if (length < 5 || length % 4 != 1) {
    problem(0, length, fmt::format("the first line has {} characters; W cells take 4 W + 1", length));
  } else if (length > 4 * kMaxSize + 1) {
    problem(0, 4 * kMaxSize, fmt::format("a maze has at most {} columns of cells", kMaxSize));
  }
  if (lines_.size() > 2 * kMaxSize + 1) {
    problem(2 * kMaxSize + 1, 0, fmt::format("a maze has at most {} rows of cells", kMaxSize));
  } else if (lines_.size() < 3 || lines_.size() % 2 == 0) {
    problem(lines_.size() - 1, 0,
            fmt::format("the maze ends after {} lines; H rows of cells take 2 H + 1", lines_.size()));
  }
  for (std::size_t row = 1; row < lines_.size() && problems_.empty(); ++row) {
    if (lines_[row].size() == length) continue;
    problem(row, std::min(length, lines_[row].size()),
            fmt::format("the line has {} characters, the first one {}", lines_[row].size(), length));
  }
  width_ = static_cast<int>(length / 4);
  height_ = static_cast<int>(lines_.size() / 2);
  return problems_.empty();
}

void MazeTextParser::read_posts_and_level_walls(std::size_t row, GridWorld& world) {
  const int y_below = height_ - 1 - static_cast<int>(row / 2);
  for (int x = 0; x <= width_; ++x) {
    const std::size_t column = 4 * static_cast<std::size_t>(x);
    if (!is_one_of(lines_[row][column], kPosts)) unknown(row, column, "a post should be");
    if (x == width_) break;
    const bool wall = read_level_wall(row, column + 1);
    const bool outer = row == 0 || row + 1 == lines_.size();
    if (outer && !wall) problem(row, column + 1, "the outer wall is missing here");
    if (!outer && !wall) world.set_open({x, y_below}, Side::kTop, true);
  }
}

bool MazeTextParser::read_level_wall(std::size_t row, std::size_t column) {
  const std::string_view drawn = lines_[row].substr(column, 3);
  if (drawn == "   ") return false;
  std::size_t walls = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (is_one_of(drawn[i], kLevelWalls)) {
      ++walls;
    } else if (drawn[i] != ' ') {
      unknown(row, column + i, "a wall or a gap should be");
      return true;
    }
  }
  if (walls < 3) problem(row, column, "half a wall; '---' is a wall, three blanks are a gap");
  return true;
}

void MazeTextParser::read_cells_and_upright_walls(std::size_t row, GridWorld& world) {
  const int y = height_ - 1 - static_cast<int>(row / 2);
  for (int x = 0; x <= width_; ++x) {
    const std::size_t column = 4 * static_cast<std::size_t>(x);
    const bool wall = read_upright_wall(row, column);
    const bool outer = x == 0 || x == width_;
    if (outer && !wall) problem(row, column, "the outer wall is missing here");
    if (!outer && !wall) world.set_open({x, y}, Side::kLeft, true);
    if (x < width_) read_cell(row, column + 1, {x, y}, world);
  }
}

bool MazeTextParser::read_upright_wall(std::size_t row, std::size_t column) {
  const char drawn = lines_[row][column];
  if (drawn == ' ') return false;
  if (!is_one_of(drawn, kUprightWalls)) unknown(row, column, "'|' or a blank should be");
  return true;
}

void MazeTextParser::read_cell(std::size_t row, std::size_t column, Cell cell, GridWorld& world) {
  for (const std::size_t beside : {column, column + 2}) {
    if (lines_[row][beside] != ' ') unknown(row, beside, "a cell should be blank");
  }
  switch (lines_[row][column + 1]) {
    case ' ':
      return;
    case 'G':
    case 'g':
      world.goals.push_back(cell);
      return;
    case 'S':
    case 's':
      if (has_start_) problem(row, column + 1, "a second start");
      has_start_ = true;
      world.start = cell;
      return;
    default:
      unknown(row, column + 1, "S, G or a blank should be");
  }
}

char cell_mark(const GridWorld& world, Cell cell) {
  if (cell == world.start) return 'S';
  return std::find(world.goals.begin(), world.goals.end(), cell) != world.goals.end() ? 'G' : ' ';
}

}  // namespace

Result<MazeFile> parse_maze_text(std::string_view text, const std::string& name) {
  return MazeTextParser(name).parse(text);
}

std::string maze_text(const GridWorld& world) {
  std::string text;
  text.reserve((2 * static_cast<std::size_t>(world.height()) + 1) *
               (4 * static_cast<std::size_t>(world.width()) + 2));
  for (int y = world.height() - 1; y >= 0; --y) {
    for (int x = 0; x < world.width(); ++x)
      text += contains(world.open({x, y}), Side::kTop) ? "o   " : "o---";
    text += "o\n";
    for (int x = 0; x < world.width(); ++x) {
      text += contains(world.open({x, y}), Side::kLeft) ? "  " : "| ";
      text += cell_mark(world, {x, y});
      text += ' ';
    }
    text += "|\n";
  }
  for (int x = 0; x < world.width(); ++x) text += "o---";
  return text + "o\n";
}

}  // namespace aisle
