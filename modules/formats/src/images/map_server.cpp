#include "aisle/formats/images/map_server.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace aisle {

std::string pgm_bytes(const OccupancyImage& image) {
  if (image.width <= 0 || image.height <= 0 ||
      image.cells.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    throw std::invalid_argument(
        fmt::format("pgm_bytes: {} cells for {} x {}", image.cells.size(), image.width, image.height));
  }
  std::string bytes = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
  bytes.append(image.cells.begin(), image.cells.end());
  return bytes;
}

std::string map_server_yaml(const OccupancyImage& image, std::string_view image_name) {
  return fmt::format(
      "image: {}\n"
      "resolution: {:.6g}\n"
      "origin: [{:.6f}, {:.6f}, 0.0]\n"
      "negate: 0\n"
      "occupied_thresh: 0.65\n"
      "free_thresh: 0.196\n",
      image_name, image.resolution_m, image.origin_m.x(), image.origin_m.y());
}

}  // namespace aisle
