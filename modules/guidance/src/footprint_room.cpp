#include "aisle/guidance/footprint_room.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSlice_m = 0.2;  // of the footprint's length that one disc covers
constexpr double kWayCheck_m = 0.1;

}  // namespace

FootprintRoom::FootprintRoom(const Footprint& footprint, double margin_m)
    : footprint_(footprint), margin_m_(margin_m) {
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

double FootprintRoom::standing_spare_m(const FloorGrid& floor, const FloorClearance& clearance,
                                       const Pose2& T_map_vehicle) const {
  const Vec2 ahead = unit(T_map_vehicle.theta);
  double least_m = clearance.far_m();
  for (const Vec2& p : p_vehicle_discs_) {
    const FloorCell cell = floor.cell_at(T_map_vehicle.position() + p.x() * ahead);
    least_m = std::min(least_m, clearance.to_occupied_m(cell));
  }
  return least_m - radius_m_;
}

bool FootprintRoom::fits_barely(const FloorGrid& floor, const FloorClearance& clearance,
                                const Pose2& T_map_vehicle, double spare_m) const {
  if (standing_spare_m(floor, clearance, T_map_vehicle) < std::min(0.0, spare_m)) return false;
  const Vec2 ahead = unit(T_map_vehicle.theta), aside = left_normal(ahead);
  const double step_m = 0.8 * floor.cell_m(), inset_m = 1.1 * floor.cell_m() - margin_m_ / 2,
               half_m = footprint_.width_m / 2;
  const int columns = static_cast<int>((footprint_.front_m + footprint_.rear_m - 2 * inset_m) / step_m),
            rows = static_cast<int>(2 * (half_m - inset_m) / step_m);
  for (int column = 0; column <= columns; ++column) {
    for (int row = 0; row <= rows; ++row) {
      const double x = inset_m - footprint_.rear_m + column * step_m, y = inset_m - half_m + row * step_m;
      if (floor.at(Vec2(T_map_vehicle.position() + x * ahead + y * aside)) != Floor::kFree) return false;
    }
  }
  return true;
}

double FootprintRoom::free_way_m(const FloorGrid& floor, const FloorClearance& clearance, const Path& path,
                                 double from_m) const {
  const auto is_free = [&](double along_m) {
    const Pose2 T_map = path.at(along_m).T_map_path;
    return fits(floor, clearance, T_map) || fits_barely(floor, clearance, T_map, 0);
  };
  const double left_m = path.length_m() - from_m;
  const int checks = static_cast<int>(std::ceil(left_m / kWayCheck_m));
  for (int i = 0; i < checks; ++i) {
    if (!is_free(from_m + i * kWayCheck_m)) return i * kWayCheck_m;
  }
  return is_free(path.length_m()) ? left_m : left_m - kWayCheck_m;
}

}  // namespace aisle
