#include "aisle/formats/images/plan_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "aisle/formats/images/portable_bitmap.hpp"
#include "aisle/formats/images/portable_graymap.hpp"
#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "images/image_size.hpp"

namespace aisle {
namespace {

constexpr int kNearlyWhite = 248;  ///< from here on it is paper, not a drawn line
constexpr double kLightGreyShare_percent = 0.2;

bool is_too_large(const ImageSize& size) {
  return std::max(size.width_px, size.height_px) > kPlanSideMax ||
         size.width_px * size.height_px > kImagePixelsMax;
}

Image image_of(const PortableBitmap& bitmap) {
  Image image(bitmap.width, bitmap.height);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = bitmap.black[i] ? 0 : 255;
  return image;
}

/// The most frequent free grey that is not white, with a pixel that has it.
struct LightGrey {
  int value = 0;
  std::size_t pixels = 0;
  std::size_t first = 0;
};

bool is_solid(std::uint8_t grey, double solid_from_black) {
  return (255 - grey) / 255.0 >= solid_from_black;
}

LightGrey light_grey(const TransparentImage& image, double solid_from_black) {
  std::array<LightGrey, 256> greys{};
  const std::vector<std::uint8_t>& pixels = image.image.bytes;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!image.transparent.empty() && image.transparent[i] != 0) continue;
    LightGrey& grey = greys[pixels[i]];
    if (grey.pixels++ == 0) grey = {pixels[i], 1, i};
  }
  LightGrey most;
  for (int value = 0; value < kNearlyWhite; ++value) {
    const LightGrey& grey = greys[static_cast<std::size_t>(value)];
    if (!is_solid(static_cast<std::uint8_t>(value), solid_from_black) && grey.pixels > most.pixels)
      most = grey;
  }
  return most;
}

Problems warnings_of(const TransparentImage& image, const std::string& name, double solid_from_black) {
  Problems warnings;
  const auto width = static_cast<std::size_t>(image.image.width_px);
  const double percent = 100.0 / static_cast<double>(image.image.bytes.size());
  if (const auto seen_through = std::count(image.transparent.begin(), image.transparent.end(), 1)) {
    warnings.push_back({{name},
                        fmt::format("{:.3g} % of the pixels are transparent: they count as unknown, so solid",
                                    percent * static_cast<double>(seen_through))});
  }
  const LightGrey grey = light_grey(image, solid_from_black);
  if (percent * static_cast<double>(grey.pixels) >= kLightGreyShare_percent) {
    warnings.push_back(
        {{name},
         fmt::format(
             "{:.3g} % of the pixels have the light grey {}, the first at ({}, {}), and count as free; "
             "--threshold {} makes them walls",
             percent * static_cast<double>(grey.pixels), grey.value, grey.first % width, grey.first / width,
             grey.value + 1)});
  }
  return warnings;
}

}  // namespace

FloorPlan floor_plan(const TransparentImage& grey, double cell_m, double solid_from_black) {
  FloorPlan plan(grey.image.width_px, grey.image.height_px, 0);
  plan.cell_m = cell_m;
  for (int y = 0; y < plan.height; ++y) {
    const std::size_t row = plan.index(0, plan.height - 1 - y);
    for (int x = 0; x < plan.width; ++x) {
      const std::size_t pixel = row + static_cast<std::size_t>(x);
      const bool is_unseen = !grey.transparent.empty() && grey.transparent[pixel] != 0;
      plan.solid[plan.index(x, y)] = is_unseen || is_solid(grey.image.bytes[pixel], solid_from_black);
    }
  }
  return plan;
}

Result<TransparentImage> parse_plan_pixels(std::string_view bytes, const std::string& name) {
  if (const auto size = stated_image_size(bytes); size && is_too_large(*size)) {
    return Problem{
        {name},
        fmt::format("has {} x {} pixels; at most {} columns and rows, {} million in all, are read: "
                    "a smaller copy needs a larger --resolution",
                    size->width_px, size->height_px, kPlanSideMax, kImagePixelsMax / 1'000'000)};
  }
  if (bytes.starts_with("P1") || bytes.starts_with("P4")) {
    const auto bitmap = parse_pbm(bytes, name, kPlanSideMax);
    if (!bitmap) return bitmap.problems();
    return TransparentImage{image_of(*bitmap), {}};
  }
  if (bytes.starts_with("P2") || bytes.starts_with("P5")) {
    auto graymap = parse_pgm(bytes, name, kPlanSideMax);
    if (!graymap) return graymap.problems();
    return TransparentImage{std::move(*graymap), {}};
  }
  return parse_transparent_image(bytes, name);
}

Result<PlanReading> parse_plan_image(std::string_view bytes, const std::string& name, double cell_m,
                                     double solid_from_black) {
  auto pixels = parse_plan_pixels(bytes, name);
  if (!pixels) return pixels.problems();
  pixels->image = to_grey(pixels->image);
  return PlanReading{floor_plan(*pixels, cell_m, solid_from_black),
                     warnings_of(*pixels, name, solid_from_black)};
}

Result<PlanReading> read_plan_image(const std::filesystem::path& path, double cell_m,
                                    double solid_from_black) {
  const Result<std::string> bytes = read_whole_file(path, kPlanBytesMax);
  if (!bytes) return bytes.problems();
  return parse_plan_image(*bytes, path.string(), cell_m, solid_from_black);
}

}  // namespace aisle
