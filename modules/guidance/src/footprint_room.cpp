#include "aisle/guidance/footprint_room.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSlice_m = 0.2;  // of the footprint's length that one disc covers
constexpr double kWayCheck_m = 0.1;
constexpr double kTouchedCells = 0.8;  // between the points that are looked at under the footprint

/// What cells have at their middles, at any point between four of them.
template <class ValueOf>
double between_cells(const FloorGrid& floor, const Vec2& p_map, ValueOf value_of) {
  const double x = p_map.x() / floor.cell_m() - 0.5, y = p_map.y() / floor.cell_m() - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const double right = x - column, up = y - row;
  const FloorCell low{static_cast<int>(column), static_cast<int>(row)};
  const auto in_row = [&](int cell_y) -> double {
    return (1 - right) * value_of(FloorCell{low.x, cell_y}) + right * value_of(FloorCell{low.x + 1, cell_y});
  };
  return (1 - up) * in_row(low.y) + up * in_row(low.y + 1);
}

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
  return least_m(floor, T_map_vehicle, clearance.far_m(),
                 [&](FloorCell cell) { return clearance.to_doubtful_m(cell); });
}

double FootprintRoom::standing_spare_m(const FloorGrid& floor, const FloorClearance& clearance,
                                       const Pose2& T_map_vehicle) const {
  return least_m(floor, T_map_vehicle, clearance.far_m(),
                 [&](FloorCell cell) { return clearance.to_occupied_m(cell); });
}

template <class DistanceAt>
double FootprintRoom::least_m(const FloorGrid& floor, const Pose2& T_map_vehicle, double far_m,
                              DistanceAt distance_at) const {
  const Vec2 ahead = unit(T_map_vehicle.theta);
  double least_m = far_m;
  for (const Vec2& p : p_vehicle_discs_)
    least_m = std::min(least_m, between_cells(floor, T_map_vehicle.position() + p.x() * ahead, distance_at));
  return least_m - radius_m_;
}

bool FootprintRoom::fits_barely(const FloorGrid& floor, const FloorClearance& clearance,
                                const Pose2& T_map_vehicle, double spare_m) const {
  if (standing_spare_m(floor, clearance, T_map_vehicle) < std::min(0.0, spare_m)) return false;
  const Vec2 ahead = unit(T_map_vehicle.theta), aside = left_normal(ahead);
  const double inset_m = floor.cell_m() / 2;
  const double length_m = footprint_.front_m + footprint_.rear_m - 2 * inset_m,
               width_m = footprint_.width_m - 2 * inset_m;
  const auto steps_over = [&](double way_m) {
    return static_cast<int>(std::ceil(way_m / (kTouchedCells * floor.cell_m())));
  };
  const int columns = steps_over(length_m), rows = steps_over(width_m);
  for (int column = 0; column <= columns; ++column) {
    for (int row = 0; row <= rows; ++row) {
      const double x = length_m * column / columns + inset_m - footprint_.rear_m,
                   y = width_m * (static_cast<double>(row) / rows - 0.5);
      const FloorCell cell = floor.cell_at(T_map_vehicle.position() + x * ahead + y * aside);
      if (floor.at(cell) != Floor::kFree || clearance.is_barred(cell)) return false;
    }
  }
  return true;
}

double FootprintRoom::free_way_m(const FloorGrid& floor, const FloorClearance& clearance, const Path& path,
                                 double from_m, double spare_m) const {
  const auto is_free = [&](double along_m) {
    const Pose2 T_map = path.at(along_m).T_map_path;
    return fits(floor, clearance, T_map) || fits_barely(floor, clearance, T_map, spare_m);
  };
  const double left_m = path.length_m() - from_m;
  const int checks = static_cast<int>(std::ceil(left_m / kWayCheck_m));
  for (int i = 0; i < checks; ++i) {
    if (!is_free(from_m + i * kWayCheck_m)) return i * kWayCheck_m;
  }
  return is_free(path.length_m()) ? left_m : left_m - kWayCheck_m;
}

}  // namespace aisle
