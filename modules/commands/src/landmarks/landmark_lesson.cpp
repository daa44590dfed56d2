#include "landmarks/landmark_lesson.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kStartSigma_m = 0.15;  // how far from a route's start a trip begins
constexpr double kStartSigma_rad = 3 * kDegree;
constexpr double kAtStart_m = 0.05;    // the start view is what is seen before the vehicle has gone so far
constexpr double kWayPoints_m = 0.05;  // between the poses that a path is fitted to

/// The poses of a trip without those where it stood.
std::vector<Pose2> way_points(const std::vector<Pose2>& T_map_vehicle) {
  std::vector<Pose2> points;
  for (const Pose2& T : T_map_vehicle) {
    if (points.empty() || (T.position() - points.back().position()).norm() >= kWayPoints_m)
      points.push_back(T);
  }
  return points;
}

std::vector<StartSighting> start_view(const LandmarkTrip& trip, const std::vector<Pose2>& T_map_vehicle) {
  for (std::size_t i = 0; i < trip.cycles.size(); ++i) {
    const Pose2 moved = between(T_map_vehicle.front(), T_map_vehicle[i]);
    if (moved.position().norm() > kAtStart_m) break;
    if (trip.cycles[i].sightings.empty()) continue;
    std::vector<StartSighting> view;
    for (const LandmarkSighting& sighting : trip.cycles[i].sightings)
      view.push_back({moved * sighting.p_vehicle, sighting.brighter_right});
    return view;
  }
  return {};
}

}  // namespace

Result<LandmarkLesson> learn_lesson(const LandmarkTrip& trip, const std::string& route,
                                    const LandmarkLessonParams& params) {
  LearnedTrip learned = learn_landmarks(trip.cycles, trip.vehicle, params.learning);
  if (learned.map.empty()) return Problem{{}, "the trip shows no landmarks"};
  const std::vector<Pose2> points = way_points(learned.T_map_vehicle);
  if (points.size() < 2) return Problem{{}, "the vehicle stood still all the time"};
  Path path = fit_path(points, params.path);
  const auto turns_on_the_spot =
      std::any_of(path.pieces().begin(), path.pieces().end(),
                  [](const PathPiece& piece) { return piece.is_on_the_spot() && piece.arc.turn_rad != 0; });
  if (turns_on_the_spot && !trip.vehicle.is_differential)
    return Problem{{}, "the way as it was driven has turns that this vehicle cannot drive"};
  LandmarkLesson lesson;
  lesson.building.name = route;
  lesson.building.camera = trip.camera;
  lesson.building.landmarks = std::move(learned.map);
  lesson.building.wall_directions = std::move(learned.wall_directions);
  lesson.building.routes.push_back(
      {.name = route, .path = std::move(path), .start_view = start_view(trip, learned.T_map_vehicle)});
  lesson.T_map_taught = std::move(learned.T_map_vehicle);
  return lesson;
}

UncertainPose2 about_start(const Pose2& T_map_start) {
  return about(T_map_start, kStartSigma_m, kStartSigma_rad);
}

}  // namespace aisle
