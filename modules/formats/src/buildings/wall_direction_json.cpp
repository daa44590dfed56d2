#include "buildings/building_parts.hpp"

namespace aisle {
namespace {

constexpr std::size_t kDirectionsMax = 100'000;
constexpr Digits kHundredths = {2};  // of degrees

JsonFields direction_fields(WallDirection& walls) {
  return {needed(field::point("at_m", walls.p_map, kMapCoordinate_m)),
          needed(field::angle("direction_deg", walls.direction_rad, {-45, 45}, kHundredths)),
          needed(field::angle("sigma_deg", walls.sigma_rad, {0.01, 45}, kHundredths))};
}

}  // namespace

JsonPart wall_directions_part(std::string_view key, std::vector<WallDirection>& directions) {
  return objects_part(key, directions, kDirectionsMax, direction_fields);
}

}  // namespace aisle
