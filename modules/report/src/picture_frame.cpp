#include "picture_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace aisle {
namespace {

constexpr Font kTitleFont{30, kInk, true};
constexpr Font kCaptionFont{18, kQuietInk};
constexpr double kScaleBar_px = 220;  ///< at most
constexpr double kWallBody_m = 0.12;  ///< thickness of the strip shown behind a wall's face

double footer_line(const PictureScale& scale) {
  return scale.height_px - 36;
}

}  // namespace

void draw_wall_bodies(Canvas& canvas, const PictureScale& scale, std::span<const Segment2> faces) {
  std::vector<std::array<Vec2, 4>> bodies;
  for (const Segment2& face : faces) {
    const Vec2 behind = -kWallBody_m * left_normal(unit(face.heading()));
    bodies.push_back({scale.to_paper(face.start), scale.to_paper(face.end), scale.to_paper(face.end + behind),
                      scale.to_paper(face.start + behind)});
  }
  canvas.areas(bodies, kWallBody);
}

void draw_header(Canvas& canvas, const PictureScale& scale, const std::string& title,
                 const std::string& caption) {
  const auto fitted = [&](Font font, const std::string& text) {
    const double room_px = scale.width_px - 2 * kMargin_px;
    font.size_px *= std::min(1.0, room_px / std::max(1.0, canvas.text_width(text, font)));
    return font;
  };
  canvas.text({kMargin_px, 50}, title, fitted(kTitleFont, title));
  canvas.text({kMargin_px, 78}, caption, fitted(kCaptionFont, caption));
}

void draw_scale_bar(Canvas& canvas, const PictureScale& scale) {
  const double length_m = round_length(kScaleBar_px / scale.px_per_m);
  const double left = kMargin_px, right = left + length_m * scale.px_per_m, y = footer_line(scale);
  const Pen pen{kInk, 2};
  canvas.lines({{{left, y}, {right, y}}, {{left, y - 6}, {left, y + 6}}, {{right, y - 6}, {right, y + 6}}},
               pen);
  canvas.text({right + 14, y + 6}, fmt::format("{:g} m", length_m), kLabelFont);
}

Legend::Legend(Canvas& canvas, const PictureScale& scale)
    : canvas_(canvas),
      rightmost_px_(scale.width_px - kMargin_px),
      right_px_(rightmost_px_),
      y_px_(footer_line(scale)) {}

void Legend::add(const std::string& label, double width_px,
                 const std::function<void(const Vec2&)>& draw_sign) {
  constexpr double kBesideSign_px = 10, kBetweenEntries_px = 30, kRow_px = 26, kScaleBarLabel_px = 80;
  const double text_px = canvas_.text_width(label, kLabelFont);
  const double left_px = kMargin_px + (is_beside_bar_ ? kScaleBar_px + kScaleBarLabel_px : 0);
  if (right_px_ - text_px - kBesideSign_px - width_px < left_px) {
    is_beside_bar_ = false;
    right_px_ = rightmost_px_;
    y_px_ -= kRow_px;
  }
  const double text_x = right_px_ - text_px;
  canvas_.text({text_x, y_px_ + 6}, label, kLabelFont);
  draw_sign({text_x - kBesideSign_px - width_px / 2, y_px_});
  right_px_ = text_x - kBesideSign_px - width_px - kBetweenEntries_px;
}

void Legend::add_line(const std::string& label, const Pen& pen) {
  add(label, 30, [&](const Vec2& p) { canvas_.line(p - Vec2(15, 0), p + Vec2(15, 0), pen); });
}

}  // namespace aisle
