#include "aisle/report/detection_overlay.hpp"

#include <algorithm>
#include <cstddef>

#include "canvas.hpp"

namespace aisle {
namespace {

constexpr Color kGreen{0.1, 0.9, 0.2};
constexpr Color kYellow{1, 0.85, 0};
constexpr Color kRed{1, 0.15, 0.1};
constexpr Color kCyan{0, 0.9, 1};
constexpr Color kOrange{1, 0.55, 0};
constexpr Color kMagenta{1, 0.2, 0.9};
constexpr std::uint8_t kRegionTint = 110;  // of 255: how strongly the region's green covers the image

/// A point of an image on the canvas, whose origin is a pixel's corner.
Vec2 on_canvas(const Vec2& pixel) {
  return pixel + Vec2(0.5, 0.5);
}

/// The unit of line widths and dots: 2 px in a VGA image.
double stroke_px(const Image& image) {
  return std::max(1.0, std::max(image.width_px, image.height_px) / 320.0);
}

std::string overlay_png(const Image& image, const Drawing& draw) {
  return png_file(image.width_px, image.height_px, [&](Canvas& canvas) {
    canvas.image(image);
    draw(canvas);
  });
}

std::vector<Vec2> on_canvas(std::vector<Vec2> pixels) {
  for (Vec2& pixel : pixels) pixel = on_canvas(pixel);
  return pixels;
}

bool is_outline(const Image& mask, int u, int v) {
  const auto outside = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width_px && y < mask.height_px && mask.row(y)[x] == 0;
  };
  return outside(u - 1, v) || outside(u + 1, v) || outside(u, v - 1) || outside(u, v + 1);
}

Image in_colour(const Image& image) {
  if (image.channels == 3) return image;
  Image colour(image.width_px, image.height_px, 3);
  for (std::size_t i = 0; i < colour.bytes.size(); ++i) colour.bytes[i] = image.bytes[i / 3];
  return colour;
}

Image tinted(const Image& image, const Image& mask) {
  constexpr int kTint[3] = {0, 230, 60};
  Image colour = in_colour(image);
  for (int v = 0; v < mask.height_px; ++v) {
    for (int u = 0; u < mask.width_px; ++u) {
      if (mask.row(v)[u] == 0) continue;
      const int share = is_outline(mask, u, v) ? 255 : kRegionTint;
      std::uint8_t* pixel = colour.row(v) + 3 * std::ptrdiff_t{u};
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>((pixel[c] * (255 - share) + kTint[c] * share) / 255);
    }
  }
  return colour;
}

void draw_verticals(Canvas& canvas, std::span<const VerticalLine> verticals, double stroke) {
  for (const VerticalLine& line : verticals)
    canvas.line(on_canvas(line.top_px), on_canvas(line.bottom_px), {kCyan, stroke});
  for (const VerticalLine& line : verticals)
    if (line.has_floor_point) canvas.disc(on_canvas(line.bottom_px), 2 * stroke, kRed);
}

void draw_base_lines(Canvas& canvas, const BaseLines& lines, double stroke) {
  if (lines.left) canvas.polyline(on_canvas(*lines.left), {kMagenta, stroke});
  if (lines.right) canvas.polyline(on_canvas(*lines.right), {kOrange, stroke});
  if (lines.vanishing_point_px)
    canvas.ring(on_canvas(*lines.vanishing_point_px), 3 * stroke, {kYellow, stroke});
}

}  // namespace

std::string verticals_overlay_png(const Image& image, std::span<const VerticalLine> verticals) {
  return overlay_png(image, [&](Canvas& canvas) { draw_verticals(canvas, verticals, stroke_px(image)); });
}

std::string base_lines_overlay_png(const Image& image, const BaseLines& lines) {
  return overlay_png(image, [&](Canvas& canvas) { draw_base_lines(canvas, lines, stroke_px(image)); });
}

std::string features_overlay_png(const Image& image, const FoundLines& lines, const Image& floor) {
  return overlay_png(tinted(image, floor), [&](Canvas& canvas) {
    draw_verticals(canvas, lines.verticals, 0.75 * stroke_px(image));
    draw_base_lines(canvas, lines.base_lines, stroke_px(image));
  });
}

std::string stripes_overlay_png(const Image& image, std::span<const LaserStripe> stripes) {
  const double stroke = stroke_px(image);
  return overlay_png(image, [&](Canvas& canvas) {
    for (const LaserStripe& stripe : stripes) {
      canvas.polyline(on_canvas(stripe.points_px), {kGreen, stroke});
      for (const Vec2& corner : stripe.corners_px)
        canvas.ring(on_canvas(corner), 2.5 * stroke, {kYellow, 0.75 * stroke});
    }
  });
}

std::string region_overlay_png(const Image& image, const RouteRegion& region,
                               const std::optional<RouteMiddle>& middle) {
  const double stroke = stroke_px(image);
  return overlay_png(tinted(image, region.mask), [&](Canvas& canvas) {
    if (!middle) return;
    canvas.line(on_canvas(middle->near_px), on_canvas(middle->far_px), {kYellow, 0.5 * stroke});
    canvas.disc(on_canvas(middle->near_px), 2 * stroke, kYellow);
    canvas.disc(on_canvas(middle->far_px), 2 * stroke, kYellow);
    canvas.disc(on_canvas(middle->mean_px), 2 * stroke, kRed);
  });
}

}  // namespace aisle
