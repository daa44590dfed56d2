#pragma once
/// What L96 learns of a path through a room, beside the path itself.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

inline constexpr int kTurningNumbers = 13;

/// What is done in a turning (L96 section 3.2).
enum class TurningClass { kLeft, kRight, kStraightOn };

/// @param number  1 to kTurningNumbers (docs/reference/turnings.md)
TurningClass class_of_turning(int number);

/// A turning as it was marked; distances along the route from its start.
struct RoomTurning {
  int number = 1;
  double start_m = 0;
  double end_m = 0;
};

/// How much of a view's left and right is not looked at, as shares of its width.
struct MaskOut {
  double left = 0;
  double right = 0;

  friend bool operator==(const MaskOut&, const MaskOut&) = default;
};

/// L96 Figs. 8 and 9: a left or right turning mask half of the view on its first three quarters and a
/// quarter on the rest, a crossing that is passed the quarters on the sides of its branches.
/// @param along_m  within the turning
MaskOut mask_out(const RoomTurning& turning, double along_m);

/// The turning that a place on the route lies in; nullptr: none.
const RoomTurning* turning_at(const std::vector<RoomTurning>& turnings, double along_m);

/// Grey levels of the route, on a patch before the vehicle.
struct RouteBrightness {
  double grey = 128;     ///< mean
  double deviation = 0;  ///< standard deviation within the patch
};

/// In a painted frame, where the route has a dead end, or where the view is the one that was learned.
enum class ParkingStrategy { kFrame, kDeadEnd, kView };

/// What people and files call them, in the order of the strategies.
inline constexpr std::array<std::string_view, 3> kParkingWords = {"frame", "dead-end", "view"};

constexpr std::string_view parking_word(ParkingStrategy parking) {
  return kParkingWords[static_cast<std::size_t>(parking)];
}

/// @return nullopt for any other word
std::optional<ParkingStrategy> parking_of(std::string_view word);

/// Where the columns of a view's upper, lower, left and right part are brightest and darkest (L96 Algorithm
/// 2), as shares of the part's width: upper max, upper min, lower max, ...
using BrightnessView = std::array<double, 8>;

/// What is kept of an image to know the place again.
struct PlaceView {
  BrightnessView brightness{};
  Image columns;  ///< how bright its columns are in bands of its rows: vision's `column_view`; may be empty
};

/// The view from a place about the end of a route.
struct StopView {
  double left_m = 0;  ///< path to the end; negative: beyond it
  PlaceView seen;
};

/// A point where the route was seen to end when the path was taught: the foot of what stood there.
struct RouteEdge {
  double along_m = 0;         ///< where on the route the vehicle was when it last saw it
  Vec2 p_map = Vec2::Zero();  ///< in the frame of the route's path
};

struct RoomRoute {
  RouteBrightness brightness;
  std::vector<RoomTurning> turnings;  ///< in order; they may overlap
  ParkingStrategy parking = ParkingStrategy::kView;
  Vec2 frame_size_m = Vec2::Zero();  ///< kFrame: of the painted rectangle, outer, along the path and across
  std::vector<StopView> views;       ///< kView: on the last path segment, or about its end
  std::vector<RouteEdge> edges;      ///< none: the path is driven by odometry and by the route's middle alone
};

}  // namespace aisle
