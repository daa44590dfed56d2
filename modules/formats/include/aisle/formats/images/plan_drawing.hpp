#pragma once
/// Floor plans as drawings: SVG, PDF and DXF, rendered to the cells that images have; see
/// docs/formats/plan.md.

#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"

namespace aisle {

enum class DrawingKind { kSvg, kPdf, kDxf };

/// By the first bytes; nullopt: no drawing.
std::optional<DrawingKind> drawing_kind_of(std::string_view bytes);

struct DrawingScale {
  double cell_m = 0.05;          ///< side of a cell of the plan
  std::optional<double> unit_m;  ///< length of the drawing's unit; none: what the file says
};

/// The plan that a drawing shows: a cell is solid where anything dark is drawn in it. Units are those of the
/// SVG's viewBox, PDF points, and DXF drawing units. A drawing that does not say how large it is, makes more
/// than 2700 cells a side, or is smaller than a metre, is a problem. Warns of what is not read: further
/// pages, texts.
/// @param solid_from_black  as in floor_plan()
Result<PlanReading> parse_plan_drawing(std::string_view bytes, const std::string& name,
                                       const DrawingScale& scale, double solid_from_black = kSolidFromBlack);

}  // namespace aisle
