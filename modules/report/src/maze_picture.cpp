#include "aisle/report/maze_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "aisle/exploration/grid_explorer.hpp"
#include "canvas.hpp"
#include "palette.hpp"

namespace aisle {
namespace {

constexpr Color kUnknown{0.90, 0.91, 0.93};
constexpr Color kSpot{0.62, 0.66, 0.71};
constexpr Color kExploring{0.13, 0.47, 0.86};
constexpr Color kRetreating{0.93, 0.49, 0.10};
constexpr Color kCrossing{0.78, 0.13, 0.20};

constexpr double kMazeMargin_px = 40;
constexpr double kMazeHeader_px = 84;
constexpr double kMazeFooter_px = 60;

/// The vehicle's moves, with the state in which it made each.
struct Run {
  std::vector<Side> moves;
  std::vector<bool> exploring;
};

class MazeDrawing {
 public:
  explicit MazeDrawing(const MazePicture& picture)
      : picture_(picture),
        world_(picture.world),
        explorer_(grid_rules(picture.rules), world_.width(), world_.height(), world_.start),
        cell_px_(std::clamp(720.0 / std::max(world_.width(), world_.height()), 4.0, 44.0)) {
    while (const auto side = explorer_.step(world_.open(explorer_.at_index()))) {
      run_.moves.push_back(*side);
      run_.exploring.push_back(explorer_.transducer().state() == static_cast<Symbol>(GridState::kExploring));
    }
  }

  int width_px() const {
    return static_cast<int>(std::max(3 * kMazeMargin_px + 2 * panel_width_px(), 760.0));
  }
  int height_px() const { return static_cast<int>(kMazeHeader_px + panel_height_px() + kMazeFooter_px); }

  void draw_on(Canvas& canvas) const {
    canvas.fill(kPaper);
    draw_header(canvas);
    draw_unknown(canvas);
    draw_trace(canvas);
    draw_marks(canvas);
    draw_walls(canvas, 0, [this](std::size_t cell) { return world_.open(cell); });
    draw_walls(canvas, 1, [this](std::size_t cell) {
      return explorer_.map().visited(cell) ? explorer_.map().open(cell) : kEverySide;
    });
    draw_start(canvas);
    draw_legend(canvas);
  }

 private:
  double panel_width_px() const { return cell_px_ * world_.width(); }
  double panel_height_px() const { return cell_px_ * world_.height(); }

  /// A point of a cell; (0, 0) is the cell's bottom left corner, (1, 1) its top right one.
  Vec2 on_paper(int panel, Cell cell, double x = 0.5, double y = 0.5) const {
    const double left = kMazeMargin_px + panel * (panel_width_px() + kMazeMargin_px);
    return {left + cell_px_ * (cell.x + x), kMazeHeader_px + cell_px_ * (world_.height() - cell.y - y)};
  }

  template <class Open>
  void draw_walls(Canvas& canvas, int panel, Open open) const {
    std::vector<std::pair<Vec2, Vec2>> walls;
    for (std::size_t i = 0; i < world_.size(); ++i) {
      const Cell cell = world_.cell(i);
      const Sides sides = open(i);
      const auto wall = [&](double x1, double y1, double x2, double y2) {
        walls.emplace_back(on_paper(panel, cell, x1, y1), on_paper(panel, cell, x2, y2));
      };
      if (!contains(sides, Side::kLeft)) wall(0, 0, 0, 1);
      if (!contains(sides, Side::kRight)) wall(1, 0, 1, 1);
      if (!contains(sides, Side::kBottom)) wall(0, 0, 1, 0);
      if (!contains(sides, Side::kTop)) wall(0, 1, 1, 1);
    }
    canvas.lines(walls, {kInk, std::clamp(cell_px_ / 12, 1.0, 3.0)});
  }

  void draw_header(Canvas& canvas) const {
    std::size_t visited = 0;
    for (std::size_t i = 0; i < world_.size(); ++i) visited += explorer_.map().visited(i);
    canvas.text({kMazeMargin_px, 38}, picture_.title, {22, kInk, true});
    canvas.text({kMazeMargin_px, 64},
                fmt::format("rules {}: {} cells visited in {} moves", name_of(picture_.rules), visited,
                            run_.moves.size()),
                {15, kQuietInk});
    const std::string learned = "learned map";
    const Font font{15, kQuietInk};
    canvas.text({width_px() - kMazeMargin_px - canvas.text_width(learned, font), 64}, learned, font);
  }

  void draw_unknown(Canvas& canvas) const {
    std::vector<std::array<Vec2, 4>> areas;
    for (std::size_t i = 0; i < world_.size(); ++i) {
      if (explorer_.map().visited(i)) continue;
      for (const int panel : {0, 1}) {
        const Cell cell = world_.cell(i);
        areas.push_back({on_paper(panel, cell, 0, 0), on_paper(panel, cell, 1, 0),
                         on_paper(panel, cell, 1, 1), on_paper(panel, cell, 0, 1)});
      }
    }
    canvas.areas(areas, kUnknown);
  }

  /// The vehicle keeps to the right, so that the traces of both directions lie side by side.
  void draw_trace(Canvas& canvas) const {
    const double width_px = std::clamp(cell_px_ / 14, 0.8, 2.5);
    Cell at = world_.start;
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < run_.moves.size(); ++i) {
      const bool new_state = i == 0 || run_.exploring[i] != run_.exploring[i - 1];
      if (i > 0) add_turn(line, at, run_.moves[i - 1], run_.moves[i]);
      if (i > 0 && new_state) {
        canvas.polyline(line, {run_.exploring[i] ? kRetreating : kExploring, width_px});
        line.erase(line.begin(), line.end() - 1);
      }
      if (i == 0) line.push_back(on_lane(at, run_.moves[i]));
      at = neighbour(at, run_.moves[i]);
    }
    if (line.empty()) return;
    line.push_back(on_lane(at, run_.moves.back()));
    canvas.polyline(line, {run_.exploring.back() ? kExploring : kRetreating, width_px});
  }

  static Vec2 to_the_right(Side heading) {
    constexpr double kOffset = 0.13;
    const Cell step = neighbour({0, 0}, heading);
    return {kOffset * step.y, -kOffset * step.x};
  }

  Vec2 on_lane(Cell cell, Side heading) const {
    const Vec2 offset = to_the_right(heading);
    return on_paper(0, cell, 0.5 + offset.x(), 0.5 + offset.y());
  }

  /// The corner between the lane on which the vehicle arrives and the one on which it leaves.
  void add_turn(std::vector<Vec2>& line, Cell cell, Side in, Side out) const {
    if (in == out) return line.push_back(on_lane(cell, in));
    if (in == opposite(out)) {
      line.push_back(on_lane(cell, in));
      return line.push_back(on_lane(cell, out));
    }
    const Vec2 offset = to_the_right(in) + to_the_right(out);
    line.push_back(on_paper(0, cell, 0.5 + offset.x(), 0.5 + offset.y()));
  }

  void draw_marks(Canvas& canvas) const {
    std::vector<std::pair<Vec2, Vec2>> crosses;
    for (std::size_t i = 0; i < world_.size(); ++i) {
      const Cell cell = world_.cell(i);
      if (explorer_.is_explored_crossing(i)) {
        crosses.emplace_back(on_paper(0, cell, 0.3, 0.3), on_paper(0, cell, 0.7, 0.7));
        crosses.emplace_back(on_paper(0, cell, 0.3, 0.7), on_paper(0, cell, 0.7, 0.3));
      } else if (explorer_.map().visited(i)) {
        canvas.disc(on_paper(0, cell), cell_px_ * 0.06, kSpot);
      }
    }
    canvas.lines(crosses, {kCrossing, std::clamp(cell_px_ / 16, 0.8, 2.0)});
  }

  void draw_start(Canvas& canvas) const {
    for (const int panel : {0, 1}) {
      canvas.ring(on_paper(panel, world_.start), cell_px_ * 0.36,
                  {kInk, std::clamp(cell_px_ / 16, 0.8, 2.0)});
    }
  }

  void draw_legend(Canvas& canvas) const {
    double x = kMazeMargin_px;
    const double y = height_px() - 26;
    const auto entry = [&](const std::string& label) {
      const Font font{14, kInk};
      canvas.text({x + 30, y + 5}, label, font);
      x += 30 + canvas.text_width(label, font) + 26;
    };
    canvas.ring({x + 10, y}, 7, {kInk, 1.5});
    entry("start");
    canvas.line({x, y}, {x + 22, y}, {kExploring, 2.5});
    entry("exploring");
    canvas.line({x, y}, {x + 22, y}, {kRetreating, 2.5});
    entry("retreating");
    canvas.lines({{{x + 5, y - 6}, {x + 17, y + 6}}, {{x + 5, y + 6}, {x + 17, y - 6}}}, {kCrossing, 2});
    entry("explored crossing");
    canvas.disc({x + 11, y}, 3, kSpot);
    entry("visited");
    canvas.areas({{Vec2(x + 4, y - 7), Vec2(x + 18, y - 7), Vec2(x + 18, y + 7), Vec2(x + 4, y + 7)}},
                 kUnknown);
    entry("not visited");
  }

  const MazePicture& picture_;
  const GridWorld& world_;
  GridExplorer explorer_;
  Run run_;
  double cell_px_;
};

}  // namespace

Problems MazePicture::problems() const {
  if (world.width() <= kMaxSize && world.height() <= kMaxSize) return {};
  return {{{title},
           fmt::format("{} x {} cells are too many for a picture; at most {} x {} can be drawn",
                       world.width(), world.height(), kMaxSize, kMaxSize)}};
}

std::string svg(const MazePicture& picture) {
  const MazeDrawing drawing(picture);
  return svg_document(drawing.width_px(), drawing.height_px(),
                      [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace aisle
