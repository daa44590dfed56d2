#include "aisle/guidance/paths/footprint_clearance.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kRoughStrip_m = 0.2;     // length of the footprint that one rough disc covers ...
constexpr double kCloseStrip_m = 0.1;     // ... and one close disc
constexpr double kCorner_m = 0.075;       // the same at its ends
constexpr double kMuchClearance_m = 0.2;  // more clearance than this is not measured closely
constexpr double kWhole = 1e-9;           // rounding error that does not make another piece
constexpr double kNoneNear_m = 10;
constexpr double kPathCheck_m = 0.1;
constexpr double kTouchedCells =
    0.7;  // between the points checked under the footprint, so as to miss no cell

/// Bilinear interpolation between the centres of four cells.
/// @param value_of  of a FloorCell, or of a cell inside the clearance map by its index
template <class ValueOf>
double between_cells(const KnownFloor& floor, const Vec2& p_map, ValueOf value_of) {
  const FloorClearance& clearance = floor.clearance();
  const double cell_m = floor.grid().cell_m();
  const double x = p_map.x() / cell_m - 0.5, y = p_map.y() / cell_m - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const double right = x - column, up = y - row;
  const auto between = [&](double low_left, double low_right, double high_left, double high_right) {
    return (1 - up) * ((1 - right) * low_left + right * low_right) +
           up * ((1 - right) * high_left + right * high_right);
  };
  const FloorCell low{static_cast<int>(column), static_cast<int>(row)}, high{low.x + 1, low.y + 1};
  if (clearance.room().contains(low) && clearance.room().contains(high)) {
    const std::size_t below = clearance.index(low), above = below + clearance.columns();
    return between(value_of(below), value_of(below + 1), value_of(above), value_of(above + 1));
  }
  return between(value_of(low), value_of(FloorCell{high.x, low.y}), value_of(FloorCell{low.x, high.y}),
                 value_of(high));
}

}  // namespace

FootprintClearance::FootprintClearance(const Footprint& footprint, double margin_m)
    : footprint_(footprint), margin_m_(margin_m) {
  const double half_m = footprint.width_m / 2;
  const auto piece = [&](double from_m, double to_m) { return Piece{{from_m, -half_m}, {to_m, half_m}}; };
  const Vec2 strip_m(kCloseStrip_m, footprint.width_m), corner_m(kCorner_m, kCorner_m);
  cover(piece(-footprint.rear_m, footprint.front_m), {kRoughStrip_m, footprint.width_m}, rough_);
  const double end_m = std::hypot(half_m, kCloseStrip_m / 2) - kCloseStrip_m / 2;
  const double behind_m = std::min(-footprint.rear_m + end_m, footprint.front_m),
               before_m = std::max(footprint.front_m - end_m, behind_m);
  if (before_m > behind_m) cover(piece(behind_m, before_m), strip_m, close_);
  cover(piece(-footprint.rear_m, behind_m), corner_m, close_);
  if (before_m < footprint.front_m) cover(piece(before_m, footprint.front_m), corner_m, close_);
}

/// Covers a piece of the footprint with discs around equal parts of at most a size; skips covered parts.
void FootprintClearance::cover(const Piece& piece, const Vec2& size_max_m, std::vector<Disc>& discs) const {
  const Vec2 size_m = piece.high - piece.low;
  const int columns = static_cast<int>(std::ceil(size_m.x() / size_max_m.x() - kWhole));
  const int rows = static_cast<int>(std::ceil(size_m.y() / size_max_m.y() - kWhole));
  const Vec2 half(size_m.x() / columns / 2, size_m.y() / rows / 2);
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const Vec2 middle = piece.low + Vec2((2 * column + 1) * half.x(), (2 * row + 1) * half.y());
      const bool is_covered = std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
        const Vec2 farthest = (middle - disc.p_vehicle).cwiseAbs() + half;
        return farthest.norm() + margin_m_ <= disc.radius_m;
      });
      if (!is_covered) discs.push_back({middle, half.norm() + margin_m_});
    }
  }
}

double FootprintClearance::clearance_m(const KnownFloor& floor, const Pose2& T_map_vehicle,
                                       double enough_m) const {
  return least_m(floor, T_map_vehicle, enough_m,
                 [&](auto cell) { return floor.clearance().to_doubtful_m(cell); });
}

double FootprintClearance::standing_clearance_m(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
  return least_m(floor, T_map_vehicle, -kNoneNear_m,
                 [&](auto cell) { return floor.clearance().to_occupied_m(cell); });
}

/// Stops at the first disc with less than enough clearance.
template <class DistanceAt>
double FootprintClearance::least_m(const KnownFloor& floor, const Pose2& T_map_vehicle, double enough_m,
                                   DistanceAt distance_at) const {
  const Mat2 R_map_vehicle = rotation(T_map_vehicle.theta);
  const auto least = [&](const std::vector<Disc>& discs, double at_most_m, double enough_there_m) {
    for (const Disc& disc : discs) {
      const Vec2 p_map = T_map_vehicle.position() + R_map_vehicle * disc.p_vehicle;
      at_most_m = std::min(at_most_m, between_cells(floor, p_map, distance_at) - disc.radius_m);
      if (at_most_m < enough_there_m) break;
    }
    return at_most_m;
  };
  const double rough_m = least(rough_, kNoneNear_m, kMuchClearance_m);
  return rough_m >= kMuchClearance_m ? rough_m : least(close_, kMuchClearance_m, enough_m);
}

bool FootprintClearance::fits_barely(const KnownFloor& floor, const Pose2& T_map_vehicle, double clearance_m,
                                     const RelaxedClearance& least) const {
  const auto suffices = [](double actual_m, double least_m) {
    return actual_m >= std::min(0.0, least_m - kClearanceNoise_m);
  };
  return suffices(clearance_m, least.free_m) &&
         suffices(standing_clearance_m(floor, T_map_vehicle), least.standing_m) &&
         lies_on_free(floor, T_map_vehicle);
}

bool FootprintClearance::lies_on(const KnownFloor& floor, const Pose2& T_map_vehicle,
                                 const std::function<bool(FloorCell)>& is_good) const {
  const Vec2 ahead = unit(T_map_vehicle.theta), lateral = left_normal(ahead);
  const FloorGrid& grid = floor.grid();
  const double inset_m = grid.cell_m() / 2;
  const double length_m = footprint_.front_m + footprint_.rear_m - 2 * inset_m,
               width_m = footprint_.width_m - 2 * inset_m;
  const auto steps_over = [&](double path_m) {
    return static_cast<int>(std::ceil(path_m / (kTouchedCells * grid.cell_m())));
  };
  const int columns = steps_over(length_m), rows = steps_over(width_m);
  for (int row = 0; row <= rows; ++row) {
    const double y = width_m * (static_cast<double>(row) / rows - 0.5);
    for (int column = 0; column <= columns;) {
      const double x = length_m * column / columns + inset_m - footprint_.rear_m;
      const FloorCell cell = grid.cell_at(T_map_vehicle.position() + x * ahead + y * lateral);
      const double free_m = floor.clearance().to_doubtful_m(cell);
      if (free_m <= 0 && !is_good(cell)) return false;
      column += std::max(1, static_cast<int>((free_m - grid.cell_m()) * columns / length_m));
    }
  }
  return true;
}

double FootprintClearance::free_path_m(const KnownFloor& floor, const Path& path, double from_m,
                                       const RelaxedClearance& least) const {
  const auto is_free = [&](double along_m) {
    const Pose2 T_map = path.at(along_m).T_map_path;
    const double actual_m = clearance_m(floor, T_map);
    return actual_m >= 0 || fits_barely(floor, T_map, actual_m, least);
  };
  const double left_m = path.length_m() - from_m;
  const int checks = static_cast<int>(std::ceil(left_m / kPathCheck_m));
  for (int i = 0; i < checks; ++i) {
    if (!is_free(from_m + i * kPathCheck_m)) return i * kPathCheck_m;
  }
  return is_free(path.length_m()) ? left_m : left_m - kPathCheck_m;
}

}  // namespace aisle
