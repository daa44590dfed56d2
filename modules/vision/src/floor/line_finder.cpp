#include "aisle/vision/floor/line_finder.hpp"

namespace aisle {

void LineFinderParams::describe(FieldList& fields) {
  fields.group("verticals", verticals);
  fields.group("baselines", base_lines);
}

LineFinder::LineFinder(const LineFinderParams& params, const std::optional<CameraModel>& camera)
    : base_line_params_(params.base_lines),
      verticals_(params.verticals, camera),
      base_lines_(params.base_lines, camera) {}

FoundLines LineFinder::find(const Image& image) {
  Image converted;
  const Image& grey = as_grey(image, converted);
  FoundLines lines;
  lines.verticals = verticals_.detect(grey);
  lines.base_lines = base_lines_.detect(grey, lines.verticals);
  stand_on_floor(grey, lines.base_lines, base_line_params_, lines.verticals);
  return lines;
}

}  // namespace aisle
