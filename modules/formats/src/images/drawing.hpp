#pragma once
/// What SVG, PDF and DXF files have in common: a page that paints itself with Cairo.

#include <cairo.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

struct Drawing {
  double width = 0, height = 0;  ///< in units of the drawing
  std::optional<double> unit_m;  ///< if the file says it
  /// Paints the drawing, x right and y down from (0, 0), one unit of the drawing a unit of the canvas; `cell`
  /// is the side of a plan's cell in these units. False: it cannot be painted.
  std::function<bool(cairo_t*, double cell)> paint;
  Problems warnings;
};

Result<Drawing> read_svg(std::string_view bytes, const std::string& name);
Result<Drawing> read_pdf(std::string_view bytes, const std::string& name);
Result<Drawing> read_dxf(std::string_view bytes, const std::string& name);

}  // namespace aisle
