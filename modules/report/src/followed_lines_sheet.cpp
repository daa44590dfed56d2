#include "aisle/report/followed_lines_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "canvas.hpp"
#include "palette.hpp"
#include "shrunk_picture.hpp"

namespace aisle {
namespace {

constexpr int kSheetWidth_px = 1800;
constexpr int kGap_px = 6;
constexpr std::size_t kTrailPictures = 4;  ///< how far back a trail goes
constexpr Color kAlone{0.75, 0.78, 0.82, 0.8};

/// Hues a golden section apart: neighbours in number differ most.
Color color_of(int number) {
  constexpr double kGolden = 0.618033988749895;
  const double hue = std::fmod(0.55 + kGolden * number, 1.0);
  const auto channel = [&](double offset) {
    const double h = std::fmod(hue + offset, 1.0) * 6;
    return std::clamp(std::abs(h - 3) - 1, 0.0, 1.0);
  };
  return {0.15 + 0.85 * channel(0), 0.15 + 0.85 * channel(2.0 / 3), 0.15 + 0.85 * channel(1.0 / 3)};
}

Vec2 middle_of(const VerticalLine& line) {
  return (line.top_px + line.bottom_px) / 2;
}

}  // namespace

FollowedLinesSheet::FollowedLinesSheet(std::size_t pictures)
    : columns_(pictures <= 3 ? pictures : std::max<std::size_t>(3, static_cast<std::size_t>(std::ceil(
                                                                        std::sqrt(static_cast<double>(pictures)))))),
      width_max_px_(std::max(1, kSheetWidth_px / static_cast<int>(columns_) - kGap_px)) {}

void FollowedLinesSheet::add(const Image& picture, const std::vector<VerticalLine>& lines,
                             const std::vector<int>& numbers) {
  const int height_max_px = 2 * width_max_px_;
  const double scale = std::min({1.0, static_cast<double>(width_max_px_) / picture.width_px,
                                 static_cast<double>(height_max_px) / picture.height_px});
  Cell cell{shrunk(picture, scale), lines, numbers};
  for (VerticalLine& line : cell.lines) {
    line.top_px = scale * (line.top_px + Vec2(0.5, 0.5));
    line.bottom_px = scale * (line.bottom_px + Vec2(0.5, 0.5));
  }
  cells_.push_back(std::move(cell));
}

std::string FollowedLinesSheet::png() const {
  int cell_width_px = 1, cell_height_px = 1;
  std::map<int, int> pictures_of;
  for (const Cell& cell : cells_) {
    cell_width_px = std::max(cell_width_px, cell.picture.width_px);
    cell_height_px = std::max(cell_height_px, cell.picture.height_px);
    for (const int number : cell.numbers) ++pictures_of[number];
  }
  const auto corner_of = [&](std::size_t i) {
    return Vec2(static_cast<double>(i % columns_) * (cell_width_px + kGap_px),
                static_cast<double>(i / columns_) * (cell_height_px + kGap_px));
  };
  const double stroke = std::max(1.0, cell_width_px / 250.0);
  const Font number_font{std::max(9.0, cell_width_px / 28.0), kPaper, true};

  const auto draw_line = [&](Canvas& canvas, const Vec2& corner, const VerticalLine& line, const Pen& pen) {
    canvas.line(corner + line.top_px, corner + line.bottom_px, pen);
  };
  const auto draw_trail = [&](Canvas& canvas, std::size_t i, const VerticalLine& line, int number) {
    std::vector<Vec2> trail = {corner_of(i) + middle_of(line)};
    for (std::size_t back = 1; back <= std::min(i, kTrailPictures); ++back) {
      const Cell& before = cells_[i - back];
      const auto found = std::find(before.numbers.begin(), before.numbers.end(), number);
      if (found == before.numbers.end()) break;
      trail.push_back(corner_of(i) + middle_of(before.lines[static_cast<std::size_t>(found - before.numbers.begin())]));
    }
    canvas.polyline(trail, {color_of(number), 0.75 * stroke});
    for (const Vec2& p : trail) canvas.disc(p, 1.75 * stroke, color_of(number));
  };
  const auto draw_number = [&](Canvas& canvas, const Vec2& p, int number) {
    const std::string text = std::to_string(number);
    const double half_px = canvas.text_width(text, number_font) / 2 + 2, height_px = number_font.size_px;
    canvas.areas({{p + Vec2(-half_px, 0), p + Vec2(half_px, 0), p + Vec2(half_px, -height_px),
                   p + Vec2(-half_px, -height_px)}},
                 {0, 0, 0, 0.65});
    canvas.text(p + Vec2(2 - half_px, -0.15 * height_px), text, {number_font.size_px, color_of(number), true});
  };

  const std::size_t rows = (cells_.size() + columns_ - 1) / columns_;
  const int width_px = static_cast<int>(columns_) * (cell_width_px + kGap_px) - kGap_px;
  const int height_px = std::max(1, static_cast<int>(rows) * (cell_height_px + kGap_px) - kGap_px);
  return png_file(width_px, height_px, [&](Canvas& canvas) {
    canvas.fill(kPaper);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      canvas.picture(cell.picture, corner_of(i));
      for (std::size_t k = 0; k < cell.lines.size(); ++k) {
        const bool is_followed = pictures_of[cell.numbers[k]] > 1;
        draw_line(canvas, corner_of(i), cell.lines[k],
                  is_followed ? Pen{color_of(cell.numbers[k]), stroke} : Pen{kAlone, 0.6 * stroke});
        if (!is_followed) continue;
        draw_trail(canvas, i, cell.lines[k], cell.numbers[k]);
        draw_number(canvas, corner_of(i) + cell.lines[k].bottom_px, cell.numbers[k]);
      }
    }
  });
}

}  // namespace aisle
