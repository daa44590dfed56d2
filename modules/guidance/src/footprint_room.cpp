#include "aisle/guidance/footprint_room.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSlice_m = 0.2;     // of the footprint's length that one disc covers
constexpr double kCheckEvery_m = 0.1;

}  // namespace

FootprintRoom::FootprintRoom(const Footprint& footprint, double margin_m) {
  const double length_m = footprint.front_m + footprint.rear_m;
  const auto slices = std::max(1, static_cast<int>(std::ceil(length_m / kSlice_m)));
  const double slice_m = length_m / slices;
  radius_m_ = std::hypot(footprint.width_m / 2, slice_m / 2) + margin_m;
  for (int i = 0; i < slices; ++i) p_vehicle_discs_.emplace_back(-footprint.rear_m + (i + 0.5) * slice_m, 0);
}

double FootprintRoom::spare_m(const FloorGrid& floor, const FloorClearance& clearance,
                              const Pose2& T_map_vehicle) const {
  const Vec2 ahead = unit(T_map_vehicle.theta);
  double least_m = clearance.far_m();
  for (const Vec2& p : p_vehicle_discs_) {
    const FloorCell cell = floor.cell_at(T_map_vehicle.position() + p.x() * ahead);
    least_m = std::min(least_m, clearance.to_doubtful_m(cell));
  }
  return least_m - radius_m_;
}

double FootprintRoom::free_way_m(const FloorGrid& floor, const FloorClearance& clearance, const Path& path,
                                 double from_m) const {
  for (double along_m = from_m; along_m < path.length_m(); along_m += kCheckEvery_m) {
    if (!fits(floor, clearance, path.at(along_m).T_map_path)) return along_m - from_m;
  }
  return fits(floor, clearance, path.at(path.length_m()).T_map_path) ? path.length_m() - from_m
                                                                     : path.length_m() - from_m - kCheckEvery_m;
}

}  // namespace aisle
