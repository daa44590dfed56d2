#pragma once

#include <cairo.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
  double opacity = 1;
};

struct Pen {
  Color color;
  double width_px = 1;
};

struct Font {
  double size_px = 16;
  Color color;
  bool is_bold = false;
};

/// Draws lines, areas and text in pixels from the top left corner, y down, on a vector or a pixel surface.
class Canvas {
 public:
  explicit Canvas(cairo_t* cairo);

  void fill(const Color& color);
  /// An image at its own size.
  void image(const Image& image, const Vec2& corner = Vec2::Zero());
  void line(const Vec2& start, const Vec2& end, const Pen& pen);
  void polyline(const std::vector<Vec2>& points, const Pen& pen);
  /// All lines as one shape: a transparent pen gets no darker where they cross.
  void lines(const std::vector<std::pair<Vec2, Vec2>>& ends, const Pen& pen);
  /// All areas as one shape, each with four corners in the same sense of rotation.
  void areas(const std::vector<std::array<Vec2, 4>>& corners, const Color& color);
  void disc(const Vec2& centre, double radius_px, const Color& color);
  void ring(const Vec2& centre, double radius_px, const Pen& pen);
  /// `start` is the left end of the text's baseline. If Cairo cannot read the text, only its ASCII characters
  /// are shown.
  void text(const Vec2& start, const std::string& text, const Font& font);
  double text_width(const std::string& text, const Font& font);

 private:
  void use(const Font& font);
  void stroke(const Pen& pen);

  cairo_t* cairo_;
};

using Drawing = std::function<void(Canvas&)>;

/// The same drawing as an SVG document and as a PNG file.
std::string svg_document(int width_px, int height_px, const Drawing& draw);
std::string png_file(int width_px, int height_px, const Drawing& draw);

}  // namespace aisle
