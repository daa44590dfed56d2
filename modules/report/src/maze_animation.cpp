#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/exploration/grid_explorer.hpp"
#include "aisle/report/maze_picture.hpp"
#include "gif_animation.hpp"

namespace aisle {
namespace {

enum class Ink : std::uint8_t {
  kPaper,
  kWall,
  kUnknown,
  kVisited,
  kExploring,
  kRetreating,
  kCrossing,
  kVehicle
};

constexpr GifAnimation::Palette kPalette = {{{255, 255, 255},
                                             {33, 43, 56},
                                             {226, 229, 234},
                                             {170, 180, 192},
                                             {120, 170, 235},
                                             {245, 178, 110},
                                             {199, 33, 51},
                                             {16, 122, 64}}};

constexpr std::size_t kMostFrames = 500;
constexpr int kFilmMargin_px = 6;

/// The world on the left, the learned map on the right, as palette indices.
class MazeFilm {
 public:
  explicit MazeFilm(const MazePicture& picture)
      : world_(picture.world),
        rules_(grid_rules(picture.rules)),
        cell_px_(std::clamp(288 / std::max(world_.width(), world_.height()), 4, 16)),
        width_(3 * kFilmMargin_px + 2 * (world_.width() * cell_px_ + 1)),
        height_(2 * kFilmMargin_px + world_.height() * cell_px_ + 1),
        pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                static_cast<std::uint8_t>(Ink::kPaper)) {}

  std::string film() {
    const std::size_t moves_per_frame = count_moves() / kMostFrames + 1;
    GifAnimation animation(width_, height_, kPalette);
    draw_background();
    GridExplorer explorer(rules_, world_.width(), world_.height(), world_.start);
    std::size_t moves = 0;
    while (true) {
      const std::size_t at = explorer.at_index();
      const auto side = explorer.step(world_.open(at));
      draw_visited(explorer, at);
      if (!side) break;
      if (moves++ % moves_per_frame == 0) add_frame(animation, at, kFrame_cs);
    }
    add_frame(animation, explorer.at_index(), kLastFrame_cs);
    return animation.finish();
  }

 private:
  static constexpr int kFrame_cs = 5;
  static constexpr int kLastFrame_cs = 300;

  std::size_t count_moves() const {
    GridExplorer explorer(rules_, world_.width(), world_.height(), world_.start);
    std::size_t moves = 0;
    while (explorer.step(world_.open(explorer.at_index()))) ++moves;
    return moves;
  }

  void fill(int left, int top, int width, int height, Ink ink) {
    for (int y = top; y < top + height; ++y) {
      const auto row = pixels_.begin() + std::ptrdiff_t{y} * width_;
      std::fill(row + left, row + left + width, static_cast<std::uint8_t>(ink));
    }
  }

  int left_of(int panel, Cell cell) const {
    return kFilmMargin_px + panel * (world_.width() * cell_px_ + 1 + kFilmMargin_px) + cell.x * cell_px_;
  }
  int top_of(Cell cell) const { return kFilmMargin_px + (world_.height() - 1 - cell.y) * cell_px_; }

  void draw_cell(int panel, std::size_t index, Sides open, Ink ink) {
    const Cell cell = world_.cell(index);
    const int left = left_of(panel, cell), top = top_of(cell);
    fill(left + 1, top + 1, cell_px_ - 1, cell_px_ - 1, ink);
    const auto edge = [&](Side side) { return contains(open, side) ? ink : Ink::kWall; };
    fill(left, top + 1, 1, cell_px_ - 1, edge(Side::kLeft));
    fill(left + cell_px_, top + 1, 1, cell_px_ - 1, edge(Side::kRight));
    fill(left + 1, top, cell_px_ - 1, 1, edge(Side::kTop));
    fill(left + 1, top + cell_px_, cell_px_ - 1, 1, edge(Side::kBottom));
    for (const int x : {left, left + cell_px_}) {
      for (const int y : {top, top + cell_px_}) fill(x, y, 1, 1, Ink::kWall);
    }
  }

  void draw_background() {
    for (std::size_t cell = 0; cell < world_.size(); ++cell) {
      draw_cell(0, cell, world_.open(cell), Ink::kUnknown);
      draw_cell(1, cell, kEverySide, Ink::kUnknown);
    }
  }

  void draw_visited(const GridExplorer& explorer, std::size_t cell) {
    const bool exploring = explorer.transducer().state() == static_cast<Symbol>(GridState::kExploring);
    draw_cell(0, cell, world_.open(cell), exploring ? Ink::kExploring : Ink::kRetreating);
    if (explorer.is_explored_crossing(cell)) draw_spot(0, cell, Ink::kCrossing, cell_px_ / 4);
    draw_cell(1, cell, explorer.map().open(cell), Ink::kPaper);
    if (world_.cell(cell) == world_.start) draw_spot(1, cell, Ink::kVisited, cell_px_ / 2);
  }

  void draw_spot(int panel, std::size_t index, Ink ink, int size) {
    const Cell cell = world_.cell(index);
    const int side = std::max(size, 1);
    const int inset = (cell_px_ + 1 - side) / 2;
    fill(left_of(panel, cell) + inset, top_of(cell) + inset, side, side, ink);
  }

  void add_frame(GifAnimation& animation, std::size_t at, int hundredths_s) {
    const std::vector<std::uint8_t> background = pixels_;
    draw_spot(0, at, Ink::kVehicle, cell_px_ * 2 / 3);
    animation.add_frame(pixels_, hundredths_s);
    pixels_ = background;
  }

  const GridWorld& world_;
  const GridRules& rules_;
  int cell_px_;
  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace

std::string gif(const MazePicture& picture) {
  return MazeFilm(picture).film();
}

}  // namespace aisle
