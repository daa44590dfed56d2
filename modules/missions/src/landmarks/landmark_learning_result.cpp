#include "aisle/missions/landmarks/landmark_learning_result.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kStartSigma_m = 0.15;  // deviation of a run's first pose from a route's start
constexpr double kStartSigma_rad = 3 * kDegree;
constexpr double kAtStart_m = 0.05;     // the start view is what is seen within this distance of the start
constexpr double kPathPoints_m = 0.05;  // between the poses that a path is fitted to

/// The poses of a run without those at which the vehicle stood still.
std::vector<Pose2> waypoints(const std::vector<Pose2>& T_map_vehicle) {
  std::vector<Pose2> points;
  for (const Pose2& T : T_map_vehicle) {
    if (points.empty() || (T.position() - points.back().position()).norm() >= kPathPoints_m)
      points.push_back(T);
  }
  return points;
}

std::vector<StartSighting> start_view(const LandmarkRun& run, const std::vector<Pose2>& T_map_vehicle) {
  for (std::size_t i = 0; i < run.cycles.size(); ++i) {
    const Pose2 moved = between(T_map_vehicle.front(), T_map_vehicle[i]);
    if (moved.position().norm() > kAtStart_m) break;
    if (run.cycles[i].sightings.empty()) continue;
    std::vector<StartSighting> view;
    for (const LandmarkSighting& sighting : run.cycles[i].sightings)
      view.push_back({moved * sighting.p_vehicle, sighting.brighter_right});
    return view;
  }
  return {};
}

/// Of places with the same name, the one that was named last.
std::vector<MapPlace> places_of(const LandmarkRun& run, const std::vector<Pose2>& T_map_vehicle) {
  std::vector<MapPlace> places;
  for (const auto& named : run.places) {
    std::erase_if(places, [&](const MapPlace& place) { return place.name == named.name; });
    places.push_back({named.name, T_map_vehicle[named.cycle]});
  }
  return places;
}

}  // namespace

Result<LandmarkLearningResult> learn_route(const LandmarkRun& run, const std::string& route,
                                           const LandmarkLearnerParams& params) {
  LearnedRun learned = learn_landmarks(run.cycles, run.vehicle, params.learning);
  if (learned.map.empty()) return Problem{{}, "the run shows no landmarks"};
  const std::vector<Pose2> points = waypoints(learned.T_map_vehicle);
  if (points.size() < 2) return Problem{{}, "the vehicle stood still all the time"};
  Path path = fit_path(points, params.path);
  const auto turns_on_the_spot =
      std::any_of(path.pieces().begin(), path.pieces().end(),
                  [](const PathPiece& piece) { return piece.is_on_the_spot() && piece.arc.turn_rad != 0; });
  if (turns_on_the_spot && !run.vehicle.is_differential)
    return Problem{{}, "the path as it was driven has turns that this vehicle cannot drive"};
  LandmarkLearningResult result;
  result.building.name = route;
  result.building.camera = run.camera;
  result.building.landmarks = std::move(learned.map);
  result.building.wall_directions = std::move(learned.wall_directions);
  result.building.routes.push_back(
      {.name = route, .path = std::move(path), .start_view = start_view(run, learned.T_map_vehicle)});
  result.building.places = places_of(run, learned.T_map_vehicle);
  result.T_map_taught = std::move(learned.T_map_vehicle);
  return result;
}

UncertainPose2 about_start(const Pose2& T_map_start) {
  return about(T_map_start, kStartSigma_m, kStartSigma_rad);
}

}  // namespace aisle
