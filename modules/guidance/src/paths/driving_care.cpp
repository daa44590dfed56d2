#include "aisle/guidance/paths/driving_care.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kCareAhead_m = 0.6;  // length of path ahead that is considered
constexpr double kCareEvery_m = 0.15;
constexpr double kAmpleClearance_m = 0.2;           // at full speed; less clearance slows the vehicle
constexpr double kWheelsAstray_rad = 25 * kDegree;  // steering error at which it would stand
constexpr double kCareMax = 0.3;                    // smallest share of the speed

}  // namespace

double driving_care(const VehicleDescription& vehicle, const FootprintClearance& footprint_clearance,
                    const KnownFloor& floor, const Path& path, double along_m, double steering_rad) {
  double clearance_m = kAmpleClearance_m, wheels_off_rad = 0;
  constexpr int kPlaces = static_cast<int>(kCareAhead_m / kCareEvery_m) + 1;
  for (int i = 0; i < kPlaces; ++i) {
    const PathPoint point = path.at(along_m + i * kCareEvery_m);
    clearance_m = std::min(clearance_m, footprint_clearance.clearance_m(floor, point.T_map_path));
    const double wanted_rad = std::atan(point.curvature_per_m * vehicle.front_steered.wheelbase_m);
    if (!vehicle.is_differential && i <= 1)
      wheels_off_rad = std::max(wheels_off_rad, std::abs(wanted_rad - steering_rad));
  }
  return std::clamp(std::min(clearance_m / kAmpleClearance_m, 1 - wheels_off_rad / kWheelsAstray_rad),
                    kCareMax, 1.0);
}

}  // namespace aisle
