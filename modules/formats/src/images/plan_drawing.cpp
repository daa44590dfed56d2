#include "aisle/formats/images/plan_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "images/drawing.hpp"

namespace aisle {
namespace {

constexpr int kCellsMax = 2700;            ///< a side: three pixels each stay below Cairo's 32767
constexpr int kPixelsPerCell = 3;          ///< lines are thinner than cells: the darkest pixel counts
constexpr std::ptrdiff_t kPixelBytes = 4;  // of Cairo's RGB24
constexpr double kSmallest_m = 1;          ///< smaller ones are the size of the paper

struct SurfaceEnd {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct CanvasEnd {
  void operator()(cairo_t* canvas) const { cairo_destroy(canvas); }
};

Result<Drawing> read_drawing(DrawingKind kind, std::string_view bytes, const std::string& name) {
  switch (kind) {
    case DrawingKind::kSvg:
      return read_svg(bytes, name);
    case DrawingKind::kPdf:
      return read_pdf(bytes, name);
    case DrawingKind::kDxf:
      break;
  }
  return read_dxf(bytes, name);
}

/// The darkest of red, green and blue of a pixel of Cairo's RGB24.
std::uint8_t darkest_channel(const unsigned char* pixel) {
  return std::min({pixel[0], pixel[1], pixel[2]});
}

std::optional<Image> painted(const Drawing& drawing, int columns, int rows, double cells_per_unit) {
  const std::unique_ptr<cairo_surface_t, SurfaceEnd> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns * kPixelsPerCell, rows * kPixelsPerCell));
  const std::unique_ptr<cairo_t, CanvasEnd> canvas(cairo_create(surface.get()));
  cairo_set_source_rgb(canvas.get(), 1, 1, 1);
  cairo_paint(canvas.get());
  cairo_set_source_rgb(canvas.get(), 0, 0, 0);
  cairo_scale(canvas.get(), cells_per_unit * kPixelsPerCell, cells_per_unit * kPixelsPerCell);
  if (!drawing.paint(canvas.get(), 1 / cells_per_unit)) return std::nullopt;
  if (cairo_status(canvas.get()) != CAIRO_STATUS_SUCCESS) return std::nullopt;
  cairo_surface_flush(surface.get());
  const unsigned char* pixels = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  Image image(columns, rows);
  std::fill(image.bytes.begin(), image.bytes.end(), 255);
  for (int v = 0; v < rows * kPixelsPerCell; ++v) {
    std::uint8_t* row = image.row(v / kPixelsPerCell);
    const unsigned char* pixel = pixels + static_cast<std::ptrdiff_t>(v) * stride;
    for (int u = 0; u < columns * kPixelsPerCell; ++u, pixel += kPixelBytes) {
      std::uint8_t& cell = row[u / kPixelsPerCell];
      cell = std::min(cell, darkest_channel(pixel));
    }
  }
  return image;
}

}  // namespace

std::optional<DrawingKind> drawing_kind_of(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 4096);
  if (head.starts_with("%PDF-")) return DrawingKind::kPdf;
  if (head.find("<svg") != std::string_view::npos) return DrawingKind::kSvg;
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  const bool is_code = first != std::string_view::npos &&
                       (head.substr(first).starts_with("0\n") || head.substr(first).starts_with("0\r\n") ||
                        head.substr(first).starts_with("999"));
  if (is_code && head.find("SECTION") != std::string_view::npos) return DrawingKind::kDxf;
  if (head.starts_with("AutoCAD Binary DXF")) return DrawingKind::kDxf;
  return std::nullopt;
}

Result<PlanReading> parse_plan_drawing(std::string_view bytes, const std::string& name,
                                       const DrawingScale& scale, double solid_from_black) {
  const auto kind = drawing_kind_of(bytes);
  if (!kind) return Problem{{name}, "is not an SVG, PDF or DXF drawing"};
  const Result<Drawing> drawing = read_drawing(*kind, bytes, name);
  if (!drawing) return drawing.problems();
  const std::optional<double> unit_m = scale.unit_m ? scale.unit_m : drawing->unit_m;
  if (!unit_m) return Problem{{name}, "does not say how large it is: --scale-by \"x,y x,y METRES\" does"};
  const double width_m = drawing->width * *unit_m, height_m = drawing->height * *unit_m;
  if (!(std::max(width_m, height_m) >= kSmallest_m)) {
    return Problem{
        {name},
        fmt::format("is {:.3g} x {:.3g} m, the size of paper; --scale-by \"x,y x,y METRES\" tells the "
                    "building's",
                    width_m, height_m)};
  }
  const double columns = std::ceil(width_m / scale.cell_m), rows = std::ceil(height_m / scale.cell_m);
  if (!(std::max(columns, rows) <= kCellsMax)) {
    return Problem{
        {name},
        fmt::format("makes {:.0f} x {:.0f} cells; at most {} a side are made (a larger --resolution "
                    "makes fewer)",
                    columns, rows, kCellsMax)};
  }
  auto image = painted(*drawing, std::max(1, static_cast<int>(columns)), std::max(1, static_cast<int>(rows)),
                       *unit_m / scale.cell_m);
  if (!image) return Problem{{name}, "cannot be drawn"};
  return PlanReading{floor_plan({std::move(*image), {}}, scale.cell_m, solid_from_black), drawing->warnings};
}

}  // namespace aisle
