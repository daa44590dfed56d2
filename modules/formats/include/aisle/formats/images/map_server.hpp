#pragma once
/// Occupancy grids in the format of the ROS map_server: an image and a YAML file.

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

/// How grey values stand for occupancy: the modes of nav2_map_server.
enum class MapMode {
  kTrinary,  ///< black occupied, white free, what is between the thresholds unknown
  kScale,    ///< the same, but grey between the thresholds is occupancy, and only transparency unknown
  kRaw,      ///< the value is the occupancy in percent; above 100 unknown
};

/// "trinary", "scale" or "raw".
const char* name_of(MapMode mode);

/// The file that the YAML names: a binary PGM (P5), or in scale mode a PNG, which can be transparent. `cells`
/// must have width * height entries; else std::invalid_argument.
std::string map_image_bytes(const OccupancyImage& image, MapMode mode = MapMode::kTrinary);

/// @param image_name  path of the image relative to the YAML file
std::string map_server_yaml(const OccupancyImage& image, std::string_view image_name,
                            MapMode mode = MapMode::kTrinary);

/// What the YAML file says about its image.
struct MapServerYaml {
  std::string image;           ///< path relative to the YAML file; "~/" is the home folder
  double resolution_m = 0.05;  ///< side of a pixel
  Pose2 T_map_plan;            ///< pose of the image's lower left corner
  MapMode mode = MapMode::kTrinary;
  bool negate = false;           ///< white is occupied; raw mode ignores it
  double occupied_above = 0.65;  ///< share of black, of white if negated
  double free_below = 0.196;     ///< likewise; in raw mode the share of 100
  Place free_below_at;           ///< where the file says so
  Problems warnings;
};

/// Reports every problem with its line and key; ignores unknown keys. `name` is the file name in problems.
Result<MapServerYaml> parse_map_server_yaml(const std::string& text, const std::string& name);

/// The plan that an image shows by the file's rule; unknown and transparent pixels are solid. In a trinary
/// map, map_saver's grey for unknown (205) is unknown even where the threshold makes it free, if it
/// outnumbers all greys that map_saver never writes: a warning says so, either way.
PlanReading plan_of_map(const TransparentImage& image, const MapServerYaml& map);

/// Reads the YAML file and the image that it names; the plan's frame `world` is the map's frame.
Result<PlanReading> read_map_server(const std::filesystem::path& yaml);

}  // namespace aisle
