#include "aisle/formats/images/plan_image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/formats/images/image_file.hpp"
#include "aisle/formats/images/portable_bitmap.hpp"
#include "aisle/formats/images/portable_graymap.hpp"
#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr int kSizeMax = 8192;

Image image_of(const PortableBitmap& bitmap) {
  Image image(bitmap.width, bitmap.height);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = bitmap.black[i] ? 0 : 255;
  return image;
}

}  // namespace

FloorPlan floor_plan(const Image& grey, double cell_m, const PlanThresholds& thresholds) {
  FloorPlan plan(grey.width_px, grey.height_px, 0);
  plan.cell_m = cell_m;
  for (int y = 0; y < plan.height; ++y) {
    const std::uint8_t* row = grey.row(plan.height - 1 - y);
    for (int x = 0; x < plan.width; ++x) {
      const double black = (thresholds.negate ? row[x] : 255 - row[x]) / 255.0;
      plan.solid[plan.index(x, y)] = black >= thresholds.free_below;
    }
  }
  return plan;
}

Result<FloorPlan> parse_plan_image(std::string_view bytes, const std::string& name, double cell_m,
                                   const PlanThresholds& thresholds) {
  if (bytes.starts_with("P1") || bytes.starts_with("P4")) {
    const auto bitmap = parse_pbm(bytes, name, kSizeMax);
    if (!bitmap) return bitmap.problems();
    return floor_plan(image_of(*bitmap), cell_m, thresholds);
  }
  const bool is_graymap = bytes.starts_with("P2") || bytes.starts_with("P5");
  const auto image = is_graymap ? parse_pgm(bytes, name, kSizeMax) : parse_image(bytes, name);
  if (!image) return image.problems();
  if (std::max(image->width_px, image->height_px) > kSizeMax) {
    return Problem{{name},
                   fmt::format("has {} x {} pixels; at most {} columns and rows are read", image->width_px,
                               image->height_px, kSizeMax)};
  }
  return floor_plan(to_grey(*image), cell_m, thresholds);
}

Result<FloorPlan> read_plan_image(const std::filesystem::path& path, double cell_m) {
  const Result<std::string> bytes = read_whole_file(path, kPlanBytesMax);
  if (!bytes) return bytes.problems();
  return parse_plan_image(*bytes, path.string(), cell_m);
}

}  // namespace aisle
