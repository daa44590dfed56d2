#include "canvas.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void draw_on(cairo_surface_t* surface, const Drawing& draw) {
  require(cairo_surface_status(surface));
  const Context cairo(cairo_create(surface), cairo_destroy);
  Canvas canvas(cairo.get());
  draw(canvas);
  require(cairo_status(cairo.get()));
}

/// Cairo numbers its surfaces over the life of the program. A fixed number makes the bytes depend on the
/// picture alone.
std::string with_fixed_ids(std::string svg) {
  const std::string mark = "id=\"surface";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at)) {
    at += mark.size();
    svg.replace(at, svg.find('"', at) - at, "0");
  }
  return svg;
}

/// Cairo refuses text that is not UTF-8, and everything drawn after it.
bool is_readable(const std::string& text) {
  const CairoSurface scratch(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
  const Context cairo(cairo_create(scratch.get()), cairo_destroy);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo.get(), text.c_str(), &extents);
  return cairo_status(cairo.get()) == CAIRO_STATUS_SUCCESS;
}

std::string readable(std::string text) {
  const bool is_utf8 = is_readable(text);
  std::replace_if(
      text.begin(), text.end(),
      [&](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < ' ' || byte == 127 || (byte > 127 && !is_utf8);
      },
      '?');
  return text;
}

void set_color(cairo_t* cairo, const Color& color) {
  cairo_set_source_rgba(cairo, color.red, color.green, color.blue, color.opacity);
}

}  // namespace

Canvas::Canvas(cairo_t* cairo) : cairo_(cairo) {
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo_, options);
  cairo_font_options_destroy(options);
}

void Canvas::fill(const Color& color) {
  set_color(cairo_, color);
  cairo_paint(cairo_);
}

void Canvas::image(const Image& image, const Vec2& corner) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width_px, image.height_px),
                             cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  const int stride = cairo_image_surface_get_stride(surface.get());
  unsigned char* const pixels = cairo_image_surface_get_data(surface.get());
  const std::size_t last = image.channels == 3 ? 2 : 0;
  for (int v = 0; v < image.height_px; ++v) {
    auto* row = reinterpret_cast<std::uint32_t*>(pixels + std::ptrdiff_t{v} * stride);
    const std::uint8_t* from = image.row(v);
    for (int u = 0; u < image.width_px; ++u, from += image.channels)
      row[u] = std::uint32_t{from[0]} << 16U | std::uint32_t{from[last / 2]} << 8U | from[last];
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_set_source_surface(cairo_, surface.get(), corner.x(), corner.y());
  cairo_paint(cairo_);
}

void Canvas::stroke(const Pen& pen) {
  set_color(cairo_, pen.color);
  cairo_set_line_width(cairo_, pen.width_px);
  cairo_stroke(cairo_);
}

void Canvas::line(const Vec2& start, const Vec2& end, const Pen& pen) {
  lines({{start, end}}, pen);
}

void Canvas::polyline(const std::vector<Vec2>& points, const Pen& pen) {
  for (const Vec2& p : points) cairo_line_to(cairo_, p.x(), p.y());
  stroke(pen);
}

void Canvas::lines(const std::vector<std::pair<Vec2, Vec2>>& ends, const Pen& pen) {
  for (const auto& [start, end] : ends) {
    cairo_move_to(cairo_, start.x(), start.y());
    cairo_line_to(cairo_, end.x(), end.y());
  }
  stroke(pen);
}

void Canvas::areas(const std::vector<std::array<Vec2, 4>>& corners, const Color& color) {
  for (const auto& area : corners) {
    cairo_new_sub_path(cairo_);
    for (const Vec2& p : area) cairo_line_to(cairo_, p.x(), p.y());
    cairo_close_path(cairo_);
  }
  set_color(cairo_, color);
  cairo_fill(cairo_);
}

void Canvas::disc(const Vec2& centre, double radius_px, const Color& color) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x(), centre.y(), radius_px, 0, 2 * kPi);
  set_color(cairo_, color);
  cairo_fill(cairo_);
}

void Canvas::ring(const Vec2& centre, double radius_px, const Pen& pen) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x(), centre.y(), radius_px, 0, 2 * kPi);
  stroke(pen);
}

void Canvas::use(const Font& font) {
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         font.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, font.size_px);
  set_color(cairo_, font.color);
}

void Canvas::text(const Vec2& start, const std::string& text, const Font& font) {
  use(font);
  cairo_move_to(cairo_, start.x(), start.y());
  cairo_show_text(cairo_, readable(text).c_str());
  cairo_new_path(cairo_);
}

double Canvas::text_width(const std::string& text, const Font& font) {
  use(font);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, readable(text).c_str(), &extents);
  return extents.x_advance;
}

std::string svg_document(int width_px, int height_px, const Drawing& draw) {
  std::string document;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &document, width_px, height_px),
                             cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw_on(surface.get(), draw);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return with_fixed_ids(std::move(document));
}

std::string png_file(int width_px, int height_px, const Drawing& draw) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px),
                             cairo_surface_destroy);
  draw_on(surface.get(), draw);
  std::string file;
  require(cairo_surface_write_to_png_stream(surface.get(), append, &file));
  return file;
}

}  // namespace aisle
