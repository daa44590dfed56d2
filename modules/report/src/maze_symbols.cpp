#include "aisle/report/maze_symbols.hpp"

#include <utility>
#include <vector>

#include "canvas.hpp"
#include "palette.hpp"

namespace aisle {
namespace {

constexpr Color kExplored{0.80, 0.82, 0.85};
constexpr Color kFalseWall{0.78, 0.13, 0.20};
constexpr Color kMove{0.13, 0.47, 0.86};

constexpr int kColumns = 16;
constexpr double kCell_px = 36;
constexpr double kPitchX_px = 64;
constexpr double kPitchY_px = 86;
constexpr double kSheetMargin_px = 30;
constexpr double kHeading_px = 34;
constexpr double kLegend_px = 50;

/// The ends of a cell's side in pixels, given the cell's top left corner.
std::pair<Vec2, Vec2> ends_of(Side side) {
  switch (side) {
    case Side::kLeft:
      return {Vec2(0, 0), Vec2(0, kCell_px)};
    case Side::kRight:
      return {Vec2(kCell_px, 0), Vec2(kCell_px, kCell_px)};
    case Side::kBottom:
      return {Vec2(0, kCell_px), Vec2(kCell_px, kCell_px)};
    case Side::kTop:
      return {Vec2(0, 0), Vec2(kCell_px, 0)};
  }
  return {};
}

void draw_wall(Canvas& canvas, const Vec2& start, const Vec2& end) {
  canvas.line(start, end, {kInk, 4});
}

void draw_open_side(Canvas& canvas, const Vec2& start, const Vec2& end) {
  canvas.line(start, end, {kQuietInk, 0.75});
}

void draw_false_wall(Canvas& canvas, const Vec2& start, const Vec2& end) {
  constexpr int kDashes = 4;
  std::vector<std::pair<Vec2, Vec2>> dashes;
  for (int i = 0; i < kDashes; ++i) {
    const double from = (i + 0.2) / kDashes, to = (i + 0.75) / kDashes;
    dashes.emplace_back(start + from * (end - start), start + to * (end - start));
  }
  canvas.lines(dashes, {kFalseWall, 2.5});
}

/// An arrow from outside through the side into the cell.
void draw_move(Canvas& canvas, const Vec2& corner, Side side) {
  const auto [start, end] = ends_of(side);
  const Vec2 entry = corner + 0.5 * (start + end);
  const Vec2 inward = (corner + Vec2(kCell_px / 2, kCell_px / 2) - entry).normalized();
  const Vec2 sideways(-inward.y(), inward.x());
  const Vec2 tip = entry + 13 * inward;
  canvas.line(entry - 11 * inward, tip, {kMove, 2});
  canvas.polyline({tip - 5 * inward + 4 * sideways, tip, tip - 5 * inward - 4 * sideways}, {kMove, 2});
}

/// Produced by the preprocessing unit wherever the vehicle is, regardless of the real walls.
bool is_put_up(GridInputKind kind) {
  return kind == GridInputKind::kClosed || kind == GridInputKind::kDetour;
}

bool has_false_wall(const GridInput& input, Side side) {
  return input.came_from == side || contains(input.false_walls, side) ||
         (is_put_up(input.kind) && !contains(input.open, side));
}

void draw_symbol(Canvas& canvas, const Vec2& corner, const GridInput& input) {
  const Vec2 right(kCell_px, 0), down(0, kCell_px);
  const bool explored = input.kind == GridInputKind::kExplored;
  if (explored) canvas.areas({{corner, corner + right, corner + right + down, corner + down}}, kExplored);
  for (const Side side : kAllSides) {
    const auto ends = ends_of(side);
    const Vec2 start = corner + ends.first, end = corner + ends.second;
    if (has_false_wall(input, side)) {
      draw_false_wall(canvas, start, end);
    } else if (explored || contains(input.open, side)) {
      draw_open_side(canvas, start, end);
    } else {
      draw_wall(canvas, start, end);
    }
  }
  if (input.came_from) {
    draw_move(canvas, corner, *input.came_from);
  } else if (!is_put_up(input.kind)) {
    canvas.ring(corner + 0.5 * (right + down), 6, {kMove, 2});
  }
}

/// Consecutive symbols of one kind.
struct Row {
  GridInputKind kind;
  std::size_t first;
  std::size_t count;
};

std::vector<Row> rows_of(const GridRules& rules) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < rules.inputs.size(); ++i) {
    const GridInputKind kind = rules.inputs[i].kind;
    if (rows.empty() || rows.back().kind != kind || rows.back().count == kColumns)
      rows.push_back({kind, i, 0});
    ++rows.back().count;
  }
  return rows;
}

void draw_legend(Canvas& canvas, double y) {
  double x = kSheetMargin_px;
  const auto entry = [&](const std::string& label) {
    const Font font{14, kInk};
    canvas.text({x + 34, y + 5}, label, font);
    x += 34 + canvas.text_width(label, font) + 26;
  };
  draw_wall(canvas, {x, y}, {x + 26, y});
  entry("wall");
  draw_open_side(canvas, {x, y}, {x + 26, y});
  entry("open side");
  draw_false_wall(canvas, {x, y}, {x + 26, y});
  entry("false wall");
  canvas.line({x, y}, {x + 26, y}, {kMove, 2});
  canvas.polyline({{x + 21, y - 4}, {x + 26, y}, {x + 21, y + 4}}, {kMove, 2});
  entry("previous move");
  canvas.ring({x + 13, y}, 6, {kMove, 2});
  entry("start");
  canvas.areas({{Vec2(x + 4, y - 9), Vec2(x + 22, y - 9), Vec2(x + 22, y + 9), Vec2(x + 4, y + 9)}},
               kExplored);
  entry("explored crossing");
}

}  // namespace

std::string input_symbols_svg(const GridRules& rules) {
  const std::vector<Row> rows = rows_of(rules);
  const double width = 2 * kSheetMargin_px + kColumns * kPitchX_px;
  const double height =
      kSheetMargin_px + static_cast<double>(rows.size()) * (kPitchY_px + kHeading_px) + kLegend_px;
  return svg_document(static_cast<int>(width), static_cast<int>(height), [&](Canvas& canvas) {
    canvas.fill(kPaper);
    double y = kSheetMargin_px;
    for (const Row& row : rows) {
      canvas.text({kSheetMargin_px, y}, std::string(name_of(row.kind)), {15, kInk, true});
      for (std::size_t i = 0; i < row.count; ++i) {
        const Vec2 corner(kSheetMargin_px + 12 + kPitchX_px * static_cast<double>(i), y + kHeading_px - 6);
        draw_symbol(canvas, corner, rules.inputs[row.first + i]);
        const std::string& name = rules.table.inputs[row.first + i];
        const Font font{13, kQuietInk};
        canvas.text(corner + Vec2((kCell_px - canvas.text_width(name, font)) / 2, kCell_px + 24), name, font);
      }
      y += kPitchY_px + kHeading_px;
    }
    draw_legend(canvas, height - kLegend_px + 10);
  });
}

}  // namespace aisle
