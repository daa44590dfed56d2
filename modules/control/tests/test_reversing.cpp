#include <gtest/gtest.h>

#include <cmath>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/reversing.hpp"
#include "aisle/vehicle/front_steered.hpp"

namespace aisle {
namespace {

VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  return vehicle;
}

/// Backwards: straight, a bend to either side as sharp as paths have, straight.
Path bends() {
  std::vector<PathPiece> pieces;
  Pose2 T_map;
  for (const Arc arc : {Arc{-1, 0}, Arc{-1.2, -1.0}, Arc{-1.2, 1.0}, Arc{-1.5, 0}}) {
    pieces.push_back({T_map, arc});
    T_map = pieces.back().end();
  }
  return Path(pieces);
}

/// The greatest cross-track error from `after_m` along the path on, for a vehicle that starts at a pose.
double lateral_max_m(const Pose2& T_map_start, double after_m, Pose2& T_path_end) {
  const VehicleDescription vehicle = cart();
  const Path path = bends();
  PathProgress progress(path);
  Pose2 T_map = T_map_start;
  double steering_rad = 0, most_m = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const PathPoint point = progress.advance(T_map);
    if (progress.has_arrived()) break;
    if (point.along_m >= after_m) most_m = std::max(most_m, std::abs(point.lateral_m));
    steering_rad = reversing_steering_rad(vehicle, path, point, T_map, 0.08, steering_rad);
    T_map = T_map * drive(vehicle.front_steered, FrontSteeredMotion{-0.012, steering_rad});
  }
  EXPECT_TRUE(progress.has_arrived());
  T_path_end = between(path.at(path.length_m()).T_map_path, T_map);
  return most_m;
}

TEST(Reversing, KeepsToBends) {
  Pose2 T_path_end;
  EXPECT_LT(lateral_max_m({}, 0, T_path_end), 0.015);
  EXPECT_NEAR(T_path_end.theta, 0, 1 * kDegree);
}

TEST(Reversing, ComesBackToThePathAndStaysOnIt) {
  for (const Pose2& T_map_start : {Pose2{0, 0.1, 0}, Pose2{0, -0.1, 0}, Pose2{0, 0, 7 * kDegree}}) {
    Pose2 T_path_end;
    EXPECT_LT(lateral_max_m(T_map_start, 1.5, T_path_end), 0.03);
    EXPECT_NEAR(T_path_end.y, 0, 0.01);
    EXPECT_NEAR(T_path_end.theta, 0, 1 * kDegree);
  }
}

}  // namespace
}  // namespace aisle
