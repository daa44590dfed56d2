#include "aisle/report/residual_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "canvas.hpp"
#include "palette.hpp"

namespace aisle {
namespace {

constexpr int kFrameWidth = 960, kLeft = 30, kTop = 90, kBarsWidth = 420;
constexpr Color kPale{0.8, 0.8, 0.84}, kFramePaper{0.97, 0.97, 0.98};
constexpr std::array<Color, 8> kGroupColors = {{{0.12, 0.47, 0.71},
                                                {0.84, 0.37, 0.05},
                                                {0.17, 0.55, 0.24},
                                                {0.76, 0.15, 0.20},
                                                {0.50, 0.33, 0.68},
                                                {0.45, 0.34, 0.29},
                                                {0.80, 0.40, 0.67},
                                                {0.40, 0.45, 0.10}}};

Color color_of(std::size_t group) {
  return kGroupColors[group % kGroupColors.size()];
}

/// The magnification (1, 2, 5, 10 ...) at which nearly all arrows are shorter than 30 pixels of the drawing.
double magnification(const ResidualPicture& picture) {
  std::vector<double> lengths;
  for (const ResidualGroup& group : picture.groups) {
    for (const Vec2& residual : group.residuals_px) {
      if (residual.allFinite()) lengths.push_back(residual.norm());
    }
  }
  if (lengths.empty()) return 1;
  const auto nearly_all = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) * 95 / 100);
  std::nth_element(lengths.begin(), nearly_all, lengths.end());
  const double scale = static_cast<double>(kFrameWidth) / picture.width_px;
  const double wanted = std::clamp(30 / (scale * std::max(*nearly_all, 1e-9)), 1.0, 1e6);
  const double decade = std::pow(10, std::floor(std::log10(wanted)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= wanted) return step * decade;
  }
  return decade;
}

void draw_arrows(const ResidualPicture& picture, double magnified, Canvas& canvas) {
  const double scale = static_cast<double>(kFrameWidth) / picture.width_px;
  for (std::size_t g = 0; g < picture.groups.size(); ++g) {
    const ResidualGroup& group = picture.groups[g];
    for (std::size_t i = 0; i < group.points_px.size(); ++i) {
      const Vec2 start = Vec2(kLeft, kTop) + scale * (group.points_px[i] + Vec2(0.5, 0.5));
      canvas.disc(start, 2, color_of(g));
      if (!group.residuals_px[i].allFinite()) continue;
      canvas.line(start, start + scale * magnified * group.residuals_px[i], {color_of(g), 1.5});
    }
  }
}

void draw_frame(double height, Canvas& canvas) {
  const double right = kLeft + kFrameWidth, bottom = kTop + height;
  canvas.areas({{Vec2(kLeft, kTop), Vec2(right, kTop), Vec2(right, bottom), Vec2(kLeft, bottom)}},
               kFramePaper);
  canvas.polyline({{kLeft, kTop}, {right, kTop}, {right, bottom}, {kLeft, bottom}, {kLeft, kTop}},
                  {kInk, 1.5});
  const Vec2 middle(kLeft + kFrameWidth / 2.0, kTop + height / 2);
  canvas.line(middle - Vec2(10, 0), middle + Vec2(10, 0), {kPale, 1});
  canvas.line(middle - Vec2(0, 10), middle + Vec2(0, 10), {kPale, 1});
}

void draw_bars(const ResidualPicture& picture, Canvas& canvas) {
  constexpr double kRow = 26, kLongest = 180;
  const double left = kLeft + kFrameWidth + 40;
  double largest = 1e-9;
  for (const ResidualGroup& group : picture.groups) largest = std::max(largest, group.rms_px);
  canvas.text({left, kTop + 12}, "rms of each view [px]", {15, kInk, true});
  for (std::size_t g = 0; g < picture.groups.size(); ++g) {
    const ResidualGroup& group = picture.groups[g];
    const double y = kTop + 20 + kRow * static_cast<double>(g);
    const double length = kLongest * group.rms_px / largest;
    canvas.areas({{Vec2(left, y + 4), Vec2(left + length, y + 4), Vec2(left + length, y + kRow - 4),
                   Vec2(left, y + kRow - 4)}},
                 color_of(g));
    canvas.text({left + length + 8, y + 18}, fmt::format("{:.2f}  {}", group.rms_px, group.name), {13, kInk});
  }
}

double frame_height(const ResidualPicture& picture) {
  return static_cast<double>(kFrameWidth) * picture.height_px / picture.width_px;
}

int drawing_height(const ResidualPicture& picture) {
  const double bars = 60 + 26.0 * static_cast<double>(picture.groups.size());
  return kTop + 60 + static_cast<int>(std::max(frame_height(picture), bars));
}

Drawing drawing_of(const ResidualPicture& picture) {
  return [&picture](Canvas& canvas) {
    canvas.fill(kPaper);
    canvas.text({kLeft, 38}, picture.title, {24, kInk, true});
    canvas.text({kLeft, 66}, picture.caption, {15, kInk});
    const double height = frame_height(picture), magnified = magnification(picture);
    draw_frame(height, canvas);
    draw_arrows(picture, magnified, canvas);
    draw_bars(picture, canvas);
    canvas.text({kLeft, kTop + height + 26},
                fmt::format("points where they were seen, residuals (seen minus expected) {:g} times as long",
                            magnified),
                {14, kInk});
  };
}

constexpr int kWidth = kLeft + kFrameWidth + 40 + kBarsWidth;

}  // namespace

std::string svg(const ResidualPicture& picture) {
  return svg_document(kWidth, drawing_height(picture), drawing_of(picture));
}

std::string png(const ResidualPicture& picture) {
  return png_file(kWidth, drawing_height(picture), drawing_of(picture));
}

}  // namespace aisle
