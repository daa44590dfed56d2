#pragma once
/// Occupancy grids in the format of the ROS map_server: a PGM image and a YAML file.

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

/// @param image_name  path of the PGM file relative to the YAML file
std::string map_server_yaml(const OccupancyImage& image, std::string_view image_name);

/// What the YAML file says about its image.
struct MapServerYaml {
  std::string image;           ///< path relative to the YAML file
  double resolution_m = 0.05;  ///< side of a pixel
  Pose2 T_map_plan;            ///< pose of the image's lower left corner
  PlanThresholds thresholds;
};

/// Reports every problem with its line and key; ignores unknown keys. `name` is the file name in problems.
Result<MapServerYaml> parse_map_server_yaml(const std::string& text, const std::string& name);

/// Reads the YAML file and the image that it names; the plan's frame `world` is the map's frame. Unknown
/// pixels count as solid.
Result<FloorPlan> read_map_server(const std::filesystem::path& yaml);

}  // namespace aisle
