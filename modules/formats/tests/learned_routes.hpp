#pragma once
/// Buildings with landmarks and routes to test with.

#include <string>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

inline Path any_path(Random& random, int pieces) {
  Pose2 T_map_piece{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-kPi, kPi)};
  std::vector<PathPiece> path;
  for (int i = 0; i < pieces; ++i) {
    const bool turns_on_the_spot = i > 0 && random.uniform() < 0.1;
    const Arc arc{turns_on_the_spot ? 0 : random.uniform(-0.5, 2), random.uniform(-0.5, 0.5)};
    path.push_back({T_map_piece, arc});
    T_map_piece = path.back().end();
  }
  return Path(std::move(path));
}

inline Landmark any_landmark(Random& random) {
  Landmark landmark;
  landmark.p_map = {random.uniform(-100, 100), random.uniform(-100, 100)};
  const Vec2 sigma_m(random.uniform(0.001, 0.2), random.uniform(0.001, 0.2));
  const double covariance = random.uniform(-0.99, 0.99) * sigma_m.x() * sigma_m.y();
  landmark.covariance << sigma_m.x() * sigma_m.x(), covariance, covariance, sigma_m.y() * sigma_m.y();
  landmark.mass = random.uniform(0, 500);
  landmark.weight = random.uniform(0.01, 9);
  landmark.sightings = static_cast<int>(random.index(2000));
  landmark.passes = static_cast<int>(random.index(20));
  landmark.brighter_right = random.uniform() < 0.5;
  return landmark;
}

/// The same, with the positions from which they were seen.
inline LandmarkMap with_views(const LandmarkMap& landmarks, Random& random) {
  LandmarkMap map;
  for (Landmark landmark : landmarks.all()) {
    landmark.seen_from = unit(random.uniform(-kPi, kPi));
    landmark.seen_near_m = random.uniform(0.5, 4);
    landmark.seen_far_m = random.uniform(4, 12);
    map.add(landmark);
  }
  return map;
}

inline Building any_learned_building(Random& random, int landmarks, int routes, int pieces) {
  Building building;
  building.name = "learned";
  building.camera.emplace();
  building.camera->intrinsics = {.fx_px = random.uniform(300, 600),
                                 .fy_px = random.uniform(300, 600),
                                 .cx_px = random.uniform(300, 340),
                                 .cy_px = random.uniform(220, 260),
                                 .k1 = random.uniform(-0.3, 0)};
  building.camera->mount.tilt_rad = random.uniform(0, 0.3);
  building.camera->mount.pan_rad = random.uniform(-3, 3);
  for (int i = 0; i < landmarks; ++i) building.landmarks.add(any_landmark(random));
  for (int i = 0; i < landmarks / 8; ++i)
    building.wall_directions.push_back({.p_map = {random.uniform(-50, 50), random.uniform(-50, 50)},
                                        .direction_rad = random.uniform(-kPi / 4, kPi / 4),
                                        .sigma_rad = random.uniform(0.1, 1) * kDegree});
  for (int i = 0; i < routes; ++i) {
    Route route{
        .name = "route \"" + std::to_string(i) + "\"", .path = any_path(random, pieces), .start_view = {}};
    for (int j = 0; j < i; ++j)
      route.start_view.push_back({{random.uniform(1, 9), random.uniform(-3, 3)}, random.uniform() < 0.5});
    building.routes.push_back(std::move(route));
  }
  return building;
}

}  // namespace aisle
