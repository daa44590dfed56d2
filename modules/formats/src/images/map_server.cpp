#include "aisle/formats/images/map_server.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {
namespace {

constexpr std::uint8_t kBlack = 0, kWhite = 255, kMiddleGrey = 128;
constexpr std::uint8_t kRawFree = 0, kRawOccupied = 100, kRawUnknown = 255;

std::string pgm_bytes(const OccupancyImage& image, MapMode mode) {
  std::string bytes = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
  for (const std::uint8_t cell : image.cells) {
    const std::uint8_t raw = cell == kCellOccupied ? kRawOccupied
                             : cell == kCellFree   ? kRawFree
                                                   : kRawUnknown;
    bytes += static_cast<char>(mode == MapMode::kRaw ? raw : cell);
  }
  return bytes;
}

std::string scale_png_bytes(const OccupancyImage& image) {
  TransparentImage grey{Image(image.width, image.height), {}};
  for (std::size_t i = 0; i < image.cells.size(); ++i) {
    const std::uint8_t cell = image.cells[i];
    const bool is_unknown = cell != kCellOccupied && cell != kCellFree;
    grey.image.bytes[i] = is_unknown ? kMiddleGrey : cell == kCellFree ? kWhite : kBlack;
    grey.transparent.push_back(is_unknown);
  }
  return png_bytes(grey);
}

}  // namespace

const char* name_of(MapMode mode) {
  switch (mode) {
    case MapMode::kTrinary:
      return "trinary";
    case MapMode::kScale:
      return "scale";
    case MapMode::kRaw:
      break;
  }
  return "raw";
}

std::string map_image_bytes(const OccupancyImage& image, MapMode mode) {
  if (image.width <= 0 || image.height <= 0 ||
      image.cells.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    throw std::invalid_argument(
        fmt::format("map_image_bytes: {} cells for {} x {}", image.cells.size(), image.width, image.height));
  }
  return mode == MapMode::kScale ? scale_png_bytes(image) : pgm_bytes(image, mode);
}

std::string map_server_yaml(const OccupancyImage& image, std::string_view image_name, MapMode mode) {
  const std::string yaml = fmt::format(
      "image: {}\n"
      "resolution: {:.6g}\n"
      "origin: [{:.6f}, {:.6f}, 0.0]\n"
      "negate: 0\n"
      "occupied_thresh: 0.65\n"
      "free_thresh: 0.196\n",
      image_name, image.resolution_m, image.origin_m.x(), image.origin_m.y());
  return mode == MapMode::kTrinary ? yaml : yaml + fmt::format("mode: {}\n", name_of(mode));
}

}  // namespace aisle
