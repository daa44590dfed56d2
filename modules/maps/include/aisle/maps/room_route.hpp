#pragma once
/// What L96 learns about a path through a room, besides the path itself.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

inline constexpr int kTurningNumbers = 13;

/// What the vehicle does in a turning (L96 section 3.2).
enum class TurningClass { kLeft, kRight, kStraightOn };

/// @param number  1 to kTurningNumbers (docs/reference/turnings.md)
TurningClass class_of_turning(int number);

/// A turning as it was marked; distances along the route from its start.
struct RoomTurning {
  int number = 1;
  double start_m = 0;
  double end_m = 0;
};

/// How much of an image is masked on the left and right, as shares of its width.
struct MaskOut {
  double left = 0;
  double right = 0;

  friend bool operator==(const MaskOut&, const MaskOut&) = default;
};

/// L96 Figs. 8 and 9: a left or right turning masks half of the image for its first three quarters and a
/// quarter for the rest; a crossing that is passed straight masks a quarter on each side with a branch.
/// @param along_m  within the turning
MaskOut mask_out(const RoomTurning& turning, double along_m);

/// The turning at this distance along the route; nullptr: none.
const RoomTurning* turning_at(const std::vector<RoomTurning>& turnings, double along_m);

/// Grey levels (0 .. 255) of the route, on a patch in front of the vehicle.
struct RouteBrightness {
  double grey = 128;     ///< mean
  double deviation = 0;  ///< standard deviation within the patch
};

/// How the vehicle parks: in a painted frame, at a dead end, or where the image matches the learned one.
enum class ParkingStrategy { kFrame, kDeadEnd, kView };

/// Their names in files and messages, in the order of the strategies.
inline constexpr std::array<std::string_view, 3> kParkingWords = {"frame", "dead-end", "view"};

constexpr std::string_view parking_word(ParkingStrategy parking) {
  return kParkingWords[static_cast<std::size_t>(parking)];
}

/// @return nullopt for any other word
std::optional<ParkingStrategy> parking_of(std::string_view word);

/// Where the columns of an image's upper, lower, left and right part are brightest and darkest (L96 Algorithm
/// 2), as shares of the part's width: upper max, upper min, lower max, ...
using BrightnessView = std::array<double, 8>;

/// What is kept of an image to recognise the place.
struct PlaceView {
  BrightnessView brightness{};
  Image columns;  ///< brightness of its columns in bands of rows: vision's `column_view`; may be empty
};

/// The view from a place near the end of a route.
struct StopView {
  double left_m = 0;  ///< distance to the end along the path; negative: beyond it
  PlaceView seen;
};

/// A floor point at the edge of the route, as seen while the path was taught.
struct RouteEdge {
  double along_m = 0;         ///< the vehicle's position along the route when it last saw it
  Vec2 p_map = Vec2::Zero();  ///< in the frame of the route's path
};

struct RoomRoute {
  RouteBrightness brightness;
  std::vector<RoomTurning> turnings;  ///< in order; they may overlap
  ParkingStrategy parking = ParkingStrategy::kView;
  Vec2 frame_size_m = Vec2::Zero();  ///< kFrame: outer size of the rectangle, along the path and across
  std::vector<StopView> views;       ///< kView: from the last part of the path, or from around its end
  std::vector<RouteEdge> edges;      ///< empty: the path is driven by odometry and the route's middle alone
};

}  // namespace aisle
