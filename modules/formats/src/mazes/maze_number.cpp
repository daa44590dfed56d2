#include "mazes/maze_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "field_reader.hpp"
#include "mazes/maze_cells.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

class MazeNumberParser {
 public:
  explicit MazeNumberParser(const std::string& name) : name_(name), problems_(name) {}

  Result<MazeFile> parse(std::string_view text) {
    for (long line = 1; !text.empty(); ++line) read_line(take_line(text), line);
    if (problems_.empty()) check_complete();
    if (!problems_.empty()) return problems_.take();
    MazeCells cells(width_, height_);
    for (const Row& row : rows_) cells.walls(row.cell) = row.walls;
    for (const Row& row : rows_) {
      cells.check(row.cell, [&](const std::string& what) { problems_.add(row.line, what); });
    }
    if (!problems_.empty()) return problems_.take();
    return MazeFile{cells.world(), MazeFormat::kNumber, false};
  }

 private:
  struct Row {
    Cell cell;
    Sides walls = kNoSides;
    long line = 0;
  };

  void read_line(std::string_view line, long number);
  int read_number(std::string_view line, FieldReader& fields, int max);
  void check_complete();

  std::string name_;
  ProblemList problems_;
  std::vector<Row> rows_;
  int width_ = 0;
  int height_ = 0;
  std::string failure_;
  std::size_t failure_column_ = 0;
};

void MazeNumberParser::read_line(std::string_view line, long number) {
  FieldReader fields(line);
  if (FieldReader(line).word().empty()) return;
  failure_.clear();
  Row row{.line = number};
  row.cell.x = read_number(line, fields, GridShape::kMaxSize - 1);
  row.cell.y = read_number(line, fields, GridShape::kMaxSize - 1);
  for (const Side side : {Side::kTop, Side::kRight, Side::kBottom, Side::kLeft}) {
    if (read_number(line, fields, 1) == 1) row.walls |= bit(side);
  }
  const std::string_view extra = fields.word();
  if (failure_.empty() && !extra.empty()) {
    failure_ = "more than the six numbers x y north east south west";
    failure_column_ = static_cast<std::size_t>(extra.data() - line.data());
  }
  if (!failure_.empty())
    return problems_.add(number, fmt::format("column {}", failure_column_ + 1), failure_);
  width_ = std::max(width_, row.cell.x + 1);
  height_ = std::max(height_, row.cell.y + 1);
  rows_.push_back(row);
}

int MazeNumberParser::read_number(std::string_view line, FieldReader& fields, int max) {
  const std::string_view word = fields.word();
  const auto value = parse_number(word);
  if (value && *value >= 0 && *value <= max && *value == static_cast<int>(*value))
    return static_cast<int>(*value);
  if (!failure_.empty()) return 0;
  failure_column_ = word.empty() ? line.size() : static_cast<std::size_t>(word.data() - line.data());
  failure_ = word.empty() ? "the line ends before its six numbers x y north east south west"
                          : fmt::format("'{}' is not a whole number from 0 to {}", printable(word), max);
  return 0;
}

void MazeNumberParser::check_complete() {
  if (rows_.empty()) return problems_.add(0, "has no cells");
  std::vector<bool> given(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), false);
  const auto index = [this](Cell cell) {
    return static_cast<std::size_t>(cell.x) * static_cast<std::size_t>(height_) +
           static_cast<std::size_t>(cell.y);
  };
  for (const Row& row : rows_) {
    if (given[index(row.cell)])
      problems_.add(row.line, fmt::format("cell ({}, {}) a second time", row.cell.x, row.cell.y));
    given[index(row.cell)] = true;
  }
  const auto missing = std::find(given.begin(), given.end(), false);
  if (missing == given.end()) return;
  const auto at = static_cast<std::size_t>(missing - given.begin());
  const auto height = static_cast<std::size_t>(height_);
  problems_.add(
      0, fmt::format("cell ({}, {}) of {} x {} is missing", at / height, at % height, width_, height_));
}

}  // namespace

Result<MazeFile> parse_maze_number(std::string_view text, const std::string& name) {
  return MazeNumberParser(name).parse(text);
}

}  // namespace aisle
