#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "aisle/formats/images/map_server.hpp"

namespace aisle {
namespace {

using GreyIsFree = std::array<bool, 256>;

GreyIsFree free_greys(const MapServerYaml& map) {
  constexpr int kRawMax = 100;
  GreyIsFree is_free{};
  for (int value = 0; value < 256; ++value) {
    const double shade = value / 255.0, occupancy = map.negate ? shade : 1 - shade;
    is_free[static_cast<std::size_t>(value)] =
        map.mode == MapMode::kRaw ? value <= kRawMax && value / double{kRawMax} < map.free_below
                                  : !(map.occupied_above < occupancy) && occupancy < map.free_below;
  }
  return is_free;
}

bool is_occupied(std::uint8_t value, const MapServerYaml& map) {
  constexpr double kRawMax = 100;
  if (map.mode == MapMode::kRaw) return value <= kRawMax && value / kRawMax >= map.occupied_above;
  const double shade = value / 255.0;
  return (map.negate ? shade : 1 - shade) > map.occupied_above;
}

/// The mean of the colours, as map_server takes it; not the eye's weights.
Image mean_of_channels(const Image& image) {
  if (image.channels == 1) return image;
  Image grey(image.width_px, image.height_px);
  for (std::size_t i = 0; i < grey.bytes.size(); ++i) {
    const std::uint8_t* rgb = image.bytes.data() + 3 * i;
    grey.bytes[i] = static_cast<std::uint8_t>((rgb[0] + rgb[1] + rgb[2] + 1) / 3);
  }
  return grey;
}

/// Pixels of map_saver's unknown grey, and of greys that it never writes.
struct UnknownGreys {
  std::size_t savers = 0;
  std::size_t others = 0;
  std::size_t first = 0;  ///< of the saver's
};

UnknownGreys unknown_greys(const Image& grey, const std::vector<std::uint8_t>& transparent) {
  UnknownGreys counts;
  for (std::size_t i = 0; i < grey.bytes.size(); ++i) {
    const std::uint8_t value = grey.bytes[i];
    if (!transparent.empty() && transparent[i] != 0) continue;
    if (value == kCellUnknown && counts.savers++ == 0) counts.first = i;
    counts.others += value != kCellUnknown && value != kCellOccupied && value != kCellFree && value != 255;
  }
  return counts;
}

/// map_saver writes 205 for unknown and any threshold beside it, by default 0.25, which makes 205 free.
Problems keep_unknown_grey(const Image& grey, const std::vector<std::uint8_t>& transparent,
                           const MapServerYaml& map, GreyIsFree& is_free) {
  if (map.mode != MapMode::kTrinary || !is_free[kCellUnknown]) return {};
  const UnknownGreys counts = unknown_greys(grey, transparent);
  if (counts.savers == 0) return {};
  const bool is_savers = counts.savers > counts.others;
  if (is_savers) is_free[kCellUnknown] = false;
  const auto width = static_cast<std::size_t>(grey.width_px);
  return {{map.free_below_at,
           fmt::format(
               "{:g} makes grey {} free, which map_saver writes for unknown; its {} pixels, the first "
               "at ({}, {}), are taken as {}{}",
               map.free_below, kCellUnknown, counts.savers, counts.first % width, counts.first / width,
               is_savers ? "unknown" : "free", is_savers ? "" : ", since the image has many other greys")}};
}

}  // namespace

PlanReading plan_of_map(const TransparentImage& image, const MapServerYaml& map) {
  GreyIsFree is_free = free_greys(map);
  const Image grey = mean_of_channels(image.image);
  PlanReading reading{FloorPlan(grey.width_px, grey.height_px, 1), map.warnings};
  const Problems guessed = keep_unknown_grey(grey, image.transparent, map, is_free);
  reading.warnings.insert(reading.warnings.end(), guessed.begin(), guessed.end());
  FloorPlan& plan = reading.plan;
  plan.cell_m = map.resolution_m;
  plan.T_world_plan = map.T_map_plan;
  reading.unseen.resize(plan.solid.size());
  for (int y = 0; y < plan.height; ++y) {
    const std::size_t row = plan.index(0, plan.height - 1 - y);
    for (int x = 0; x < plan.width; ++x) {
      const std::size_t pixel = row + static_cast<std::size_t>(x);
      const bool is_unseen = !image.transparent.empty() && image.transparent[pixel] != 0;
      const std::size_t cell = plan.index(x, y);
      plan.solid[cell] = is_unseen || !is_free[grey.bytes[pixel]];
      reading.unseen[cell] = is_unseen || (plan.solid[cell] != 0 && !is_occupied(grey.bytes[pixel], map));
    }
  }
  return reading;
}

}  // namespace aisle
