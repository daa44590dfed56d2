#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace aisle {
namespace {

constexpr Range kCell_m = {0.01, 1};
constexpr Range kLowCell = {-FloorGrid::kReach, FloorGrid::kReach};
constexpr int kRowCellsMax = 2 * FloorGrid::kReach + 1;
constexpr std::size_t kRowsMax = kRowCellsMax;
constexpr std::size_t kFloorCellsMax = 40'000'000;

constexpr char kSigns[] = {'-', '.', '#'};  // by Floor

std::string row_text(const FloorGrid& floor, int y) {
  std::string text;
  const FloorBox& box = floor.known();
  for (int x = box.low.x; x < box.end.x;) {
    const Floor kind = floor.at(FloorCell{x, y});
    int run = 1;
    while (x + run < box.end.x && floor.at(FloorCell{x + run, y}) == kind) ++run;
    x += run;
    if (x < box.end.x || kind != Floor::kUnknown)
      text += std::to_string(run) + kSigns[static_cast<std::size_t>(kind)];
  }
  return text;
}

struct Run {
  int cells = 0;
  Floor kind = Floor::kUnknown;
};

/// nullopt if the text is not a row of runs, or longer than a floor can be.
std::optional<std::vector<Run>> runs_of(std::string_view text) {
  std::vector<Run> runs;
  for (int cells = 0; !text.empty();) {
    Run run;
    const auto [sign, error] = std::from_chars(text.data(), text.data() + text.size(), run.cells);
    if (error != std::errc() || run.cells < 1 || run.cells > kRowCellsMax - cells ||
        sign == text.data() + text.size())
      return std::nullopt;
    const auto kind = std::find(std::begin(kSigns), std::end(kSigns), *sign);
    if (kind == std::end(kSigns)) return std::nullopt;
    run.kind = static_cast<Floor>(kind - std::begin(kSigns));
    text.remove_prefix(static_cast<std::size_t>(sign - text.data()) + 1);
    cells += run.cells;
    runs.push_back(run);
  }
  return runs;
}

int cells_in(const std::vector<Run>& runs) {
  return std::accumulate(runs.begin(), runs.end(), 0,
                         [](int sum, const Run& run) { return sum + run.cells; });
}

void put_row(const std::vector<Run>& runs, FloorCell cell, FloorGrid& floor) {
  for (const Run& run : runs) {
    const FloorCell end{cell.x + run.cells, cell.y};
    for (; cell.x < end.x; ++cell.x) {
      if (run.kind != Floor::kUnknown) floor.set(cell, run.kind);
    }
  }
}

/// Every row that is readable.
std::vector<std::vector<Run>> read_rows(const JsonValue& value) {
  std::vector<std::vector<Run>> rows;
  if (!value.is_list_up_to(kRowsMax)) return rows;
  int width_cells = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    std::string text;
    value.element(i).read(text);
    auto runs = runs_of(text);
    if (!runs) value.element(i).wrong("is not a row of runs like 12-40.3#");
    rows.push_back(runs.value_or(std::vector<Run>()));
    width_cells = std::max(width_cells, cells_in(rows.back()));
  }
  if (rows.size() * static_cast<std::size_t>(width_cells) <= kFloorCellsMax) return rows;
  value.wrong(fmt::format("are more than {} cells in total", kFloorCellsMax));
  return {};
}

std::string rows_json(const FloorGrid& floor) {
  std::vector<std::string> rows;
  const FloorBox& box = floor.known();
  for (int y = box.low.y; y < box.end.y; ++y) rows.push_back("\"" + row_text(floor, y) + "\"");
  return list_json(rows);
}

FloorGrid floor_of(double cell_m, FloorCell low, const std::vector<std::vector<Run>>& rows) {
  FloorGrid floor(cell_m);
  for (const std::vector<Run>& row : rows) {
    put_row(row, low, floor);
    ++low.y;
  }
  return floor;
}

JsonPart cell_part(std::string_view key, FloorCell& cell) {
  return {key, [&cell] { return fmt::format("[{}, {}]", cell.x, cell.y); },
          [&cell](const JsonValue& value) {
            if (!value.is_list_of(2)) return;
            value.element(0).read_count(cell.x, kLowCell);
            value.element(1).read_count(cell.y, kLowCell);
          }};
}

/// A floor as its file has it.
struct FloorText {
  double cell_m = 0.05;
  FloorCell low;
  std::vector<std::vector<Run>> rows;  ///< as they were read
  const FloorGrid* written = nullptr;  ///< whose rows are written
};

JsonFields floor_fields(FloorText& floor) {
  return {needed(field::number("cell_m", floor.cell_m, kCell_m, {4})),
          needed(cell_part("low_cell", floor.low)),
          needed(JsonPart{"rows", [&floor] { return rows_json(*floor.written); },
                          [&floor](const JsonValue& value) { floor.rows = read_rows(value); }})};
}

}  // namespace

std::string floor_json(const FloorGrid& floor) {
  FloorText text{floor.cell_m(), floor.known().low, {}, &floor};
  return object_json(floor_fields(text));
}

JsonPart floor_part(std::string_view key, std::optional<FloorGrid>& floor) {
  return {key, [&floor] { return floor ? floor_json(*floor) : std::string(); },
          [&floor](const JsonValue& value) {
            FloorText text;
            read_object(value, floor_fields(text));
            floor = floor_of(text.cell_m, text.low, text.rows);
          }};
}

}  // namespace aisle
