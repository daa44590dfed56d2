#pragma once
/// Maps of cells as the ROS map_server reads them: a PGM image and a YAML file.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

inline constexpr std::uint8_t kCellOccupied = 0;
inline constexpr std::uint8_t kCellUnknown = 205;
inline constexpr std::uint8_t kCellFree = 254;

struct OccupancyImage {
  int width = 0;   ///< cells along x
  int height = 0;  ///< cells along y
  double resolution_m = 0.05;
  Vec2 origin_m = Vec2::Zero();     ///< the lower left corner of the lower left cell, in `map`
  std::vector<std::uint8_t> cells;  ///< row by row, the TOP row (largest y) first, each from left to right
};

/// Binary PGM (P5). `cells` must have width * height entries; else std::invalid_argument.
std::string pgm_bytes(const OccupancyImage& image);

/// @param image_name  the PGM file's name as seen from the YAML file
std::string map_server_yaml(const OccupancyImage& image, std::string_view image_name);

/// What the YAML file says of its image.
struct MapServerYaml {
  std::string image;           ///< as seen from the YAML file
  double resolution_m = 0.05;  ///< side of a pixel
  Pose2 T_map_plan;            ///< of the image's lower left corner
  PlanThresholds thresholds;
};

/// Every problem with its line and key; keys that are not known are nobody's concern. `name` stands for the
/// file in problems.
Result<MapServerYaml> parse_map_server_yaml(const std::string& text, const std::string& name);

/// The YAML file and the image that it names; the frame `world` is the map's. What is unknown is solid.
Result<FloorPlan> read_map_server(const std::filesystem::path& yaml);

}  // namespace aisle
