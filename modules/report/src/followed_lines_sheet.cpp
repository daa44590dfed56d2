#include "aisle/report/followed_lines_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "canvas.hpp"
#include "palette.hpp"

namespace aisle {
namespace {

constexpr int kSheetWidth_px = 1800;
constexpr int kImageGap_px = 6;
constexpr std::size_t kTrailImages = 4;  ///< how many images back a trail goes
constexpr Color kAlone{0.75, 0.78, 0.82, 0.8};
constexpr Color kBehindNumber{0, 0, 0, 0.65};

std::size_t columns_for(std::size_t images) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(images))));
  return std::max(side, std::min<std::size_t>(images, 3));
}

/// Hues a golden section apart: consecutive numbers look least alike.
Color color_of(int number) {
  constexpr double kGolden = 0.618033988749895, kFirst = 0.55;
  const double hue = std::fmod(kFirst + kGolden * number, 1.0);
  const auto channel = [&](double offset) {
    const double share = std::clamp(std::abs(std::fmod(hue + offset, 1.0) * 6 - 3) - 1, 0.0, 1.0);
    return 0.15 + 0.85 * share;
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

Vec2 middle_of(const VerticalLine& line) {
  return (line.top_px + line.bottom_px) / 2;
}

}  // namespace

class FollowedLinesSheet::Sheet {
 public:
  explicit Sheet(const FollowedLinesSheet& content);

  std::string png() const;

 private:
  Vec2 corner_of(std::size_t i) const;
  void draw(Canvas& canvas, std::size_t i) const;
  void draw_trail(Canvas& canvas, std::size_t i, std::size_t line) const;
  void draw_numbers(Canvas& canvas, std::size_t i) const;
  bool is_followed(int number) const { return images_of_.at(number) > 1; }

  const std::vector<Cell>& cells_;
  std::size_t columns_;
  Vec2 step_px_ = Vec2::Zero();   // from cell to cell
  std::map<int, int> images_of_;  // of each number
  double stroke_px_ = 1;
};

FollowedLinesSheet::Sheet::Sheet(const FollowedLinesSheet& content)
    : cells_(content.cells_), columns_(content.columns_) {
  for (const Cell& cell : cells_) {
    step_px_ = step_px_.cwiseMax(Vec2(cell.image.width_px, cell.image.height_px));
    for (const int number : cell.numbers) ++images_of_[number];
  }
  stroke_px_ = std::max(1.0, step_px_.x() / 250);
  step_px_ += Vec2::Constant(kImageGap_px);
}

Vec2 FollowedLinesSheet::Sheet::corner_of(std::size_t i) const {
  const std::size_t column = i % columns_, row = i / columns_;
  return {static_cast<double>(column) * step_px_.x(), static_cast<double>(row) * step_px_.y()};
}

std::string FollowedLinesSheet::Sheet::png() const {
  const std::size_t rows = (cells_.size() + columns_ - 1) / columns_;
  const auto length_px = [](std::size_t cells, double step_px) {
    return static_cast<int>(static_cast<double>(cells) * step_px) - kImageGap_px;
  };
  return png_file(length_px(columns_, step_px_.x()), length_px(rows, step_px_.y()), [&](Canvas& canvas) {
    canvas.fill(kPaper);
    for (std::size_t i = 0; i < cells_.size(); ++i) draw(canvas, i);
  });
}

void FollowedLinesSheet::Sheet::draw(Canvas& canvas, std::size_t i) const {
  const Cell& cell = cells_[i];
  canvas.image(cell.image, corner_of(i));
  for (std::size_t k = 0; k < cell.lines.size(); ++k) {
    const int number = cell.numbers[k];
    const Pen pen = is_followed(number) ? Pen{color_of(number), stroke_px_} : Pen{kAlone, 0.6 * stroke_px_};
    canvas.line(corner_of(i) + cell.lines[k].top_px, corner_of(i) + cell.lines[k].bottom_px, pen);
  }
  for (std::size_t k = 0; k < cell.lines.size(); ++k) {
    if (is_followed(cell.numbers[k])) draw_trail(canvas, i, k);
  }
  draw_numbers(canvas, i);
}

/// From the line's midpoint through its positions in the images before, back to the first gap.
void FollowedLinesSheet::Sheet::draw_trail(Canvas& canvas, std::size_t i, std::size_t line) const {
  const int number = cells_[i].numbers[line];
  std::vector<Vec2> trail = {corner_of(i) + middle_of(cells_[i].lines[line])};
  for (std::size_t back = 1; back <= std::min(i, kTrailImages); ++back) {
    const Cell& before = cells_[i - back];
    const auto found = std::find(before.numbers.begin(), before.numbers.end(), number);
    if (found == before.numbers.end()) break;
    const auto k = static_cast<std::size_t>(found - before.numbers.begin());
    trail.push_back(corner_of(i) + middle_of(before.lines[k]));
  }
  canvas.polyline(trail, {color_of(number), 0.75 * stroke_px_});
  for (const Vec2& p : trail) canvas.disc(p, 1.75 * stroke_px_, color_of(number));
}

/// At the lines' lower ends, from left to right; a number that would cover another is left out.
void FollowedLinesSheet::Sheet::draw_numbers(Canvas& canvas, std::size_t i) const {
  const Cell& cell = cells_[i];
  const double size_px = std::max(9.0, step_px_.x() / 28);
  std::vector<std::pair<Vec2, Vec2>> taken;  // upper left and lower right corners
  for (std::size_t k = 0; k < cell.lines.size(); ++k) {
    if (!is_followed(cell.numbers[k])) continue;
    const Font font{size_px, color_of(cell.numbers[k]), true};
    const std::string text = std::to_string(cell.numbers[k]);
    const Vec2 bottom_px = corner_of(i) + cell.lines[k].bottom_px;
    const double half_px = canvas.text_width(text, font) / 2 + 2;
    const Vec2 low = bottom_px - Vec2(half_px, size_px), high = bottom_px + Vec2(half_px, 0);
    if (std::any_of(taken.begin(), taken.end(), [&](const auto& box) {
          return (low.array() < box.second.array()).all() && (high.array() > box.first.array()).all();
        }))
      continue;
    taken.emplace_back(low, high);
    canvas.areas({{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}}, kBehindNumber);
    canvas.text({low.x() + 2, high.y() - 0.15 * size_px}, text, font);
  }
}

FollowedLinesSheet::FollowedLinesSheet(std::size_t images)
    : columns_(columns_for(images)),
      width_max_px_(std::max(1, kSheetWidth_px / static_cast<int>(columns_) - kImageGap_px)) {}

void FollowedLinesSheet::add(const Image& image, const std::vector<VerticalLine>& lines,
                             const std::vector<int>& numbers) {
  const double height_max_px = 2.0 * width_max_px_;
  const double scale =
      std::min({1.0, static_cast<double>(width_max_px_) / image.width_px, height_max_px / image.height_px});
  const auto length_px = [&](int given_px) { return std::max(1, static_cast<int>(scale * given_px)); };
  Cell cell{shrunk(image, length_px(image.width_px), length_px(image.height_px)), lines, numbers};
  for (VerticalLine& line : cell.lines) {
    line.top_px = scale * (line.top_px + Vec2(0.5, 0.5));
    line.bottom_px = scale * (line.bottom_px + Vec2(0.5, 0.5));
  }
  cells_.push_back(std::move(cell));
}

std::string FollowedLinesSheet::png() const {
  return Sheet(*this).png();
}

}  // namespace aisle
