#pragma once
/// What L96 learns of a way through a room, beside the way itself.

#include <array>
#include <optional>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

inline constexpr int kTurningNumbers = 13;

/// What is done in a turning (L96 section 3.2).
enum class TurningClass { kLeft, kRight, kStraightOn };

/// @param number  1 to kTurningNumbers (METHODS 9)
TurningClass class_of_turning(int number);

/// A turning as it was marked; distances along the route from its start.
struct RoomTurning {
  int number = 1;
  double start_m = 0;
  double end_m = 0;
};

/// How much of a view's left and right is not looked at, as shares of its width.
struct BlotOut {
  double left = 0;
  double right = 0;

  friend bool operator==(const BlotOut&, const BlotOut&) = default;
};

/// L96 Figs. 8 and 9: a left or right turning blots out half of the view on its first three quarters and a
/// quarter on the rest, a crossing that is passed the quarters on the sides of its branches.
/// @param along_m  within the turning
BlotOut blot_out(const RoomTurning& turning, double along_m);

/// The turning that a place on the route lies in; nullptr: none.
const RoomTurning* turning_at(const std::vector<RoomTurning>& turnings, double along_m);

/// Grey levels of the route, on a patch before the vehicle.
struct RouteBrightness {
  double grey = 128;     ///< mean
  double deviation = 0;  ///< standard deviation within the patch
};

enum class ParkingStrategy { kFrame, kDeadEnd, kView };

/// Where the columns of a view's upper, lower, left and right part are brightest and darkest (L96 Algorithm
/// 2), as shares of the part's width: upper max, upper min, lower max, ...
using BrightnessView = std::array<double, 8>;

/// The view from a place just before the end of a route.
struct StopView {
  double left_m = 0;  ///< way to the end
  BrightnessView brightness{};
};

struct RoomRoute {
  RouteBrightness brightness;
  std::vector<RoomTurning> turnings;  ///< in order; they may overlap
  ParkingStrategy parking = ParkingStrategy::kView;
  Vec2 frame_size_m = Vec2::Zero();  ///< kFrame: of the painted rectangle, outer, along the way and across
  std::vector<StopView> views;       ///< kView: on the last stretch of the way
};

}  // namespace aisle
