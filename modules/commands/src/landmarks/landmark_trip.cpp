#include "landmarks/landmark_trip.hpp"

#include <fmt/format.h>

#include "sessions/session_trip.hpp"

namespace aisle {

const CameraDescription& corridor_camera(const VehicleDescription& vehicle) {
  const CameraDescription* named = vehicle.camera("corridor");
  return named == nullptr ? vehicle.cameras.front() : *named;
}

LandmarkTripCollector::LandmarkTripCollector(const LandmarkSightingParams& params,
                                             const VehicleDescription& vehicle)
    : trip{.vehicle = vehicle, .camera = corridor_camera(vehicle), .cycles = {}, .T_world_vehicle = {}},
      detector_(params, trip.camera.intrinsics, trip.camera.mount) {}

void LandmarkTripCollector::add(const Observation& observation) {
  LandmarkCycle cycle{
      .stamp_s = observation.stamp_s, .odometry = observation.odometry, .sightings = {}, .floor_edges = {}};
  if (const CameraPicture* picture = present_picture(observation, trip.camera.name, trip.vehicle.cycle_s)) {
    cycle.sightings = detector_.detect(*picture->image);
    for (const FloorEdge& edge : detector_.floor_edges()) cycle.floor_edges.push_back(edge.on_floor);
  }
  trip.cycles.push_back(std::move(cycle));
}

Result<LandmarkTrip> read_landmark_trip(const std::filesystem::path& session, SessionCycles& cycles,
                                        const LandmarkSightingParams& params, Progress& progress) {
  if (cycles.vehicle().cameras.empty())
    return Problem{{session.string()}, "is of a vehicle without a camera"};
  LandmarkTripCollector collector(params, cycles.vehicle());
  const auto pictures = take_observations(
      session, cycles, progress, [&](const Observation& observation) { collector.add(observation); });
  if (!pictures) return pictures.problems();
  if (*pictures == 0) {
    return Problem{{session.string()},
                   fmt::format("has no pictures of the camera {}", collector.trip.camera.name)};
  }
  auto truth = true_poses(session, collector.trip.cycles.size());
  if (!truth) return truth.problems();
  collector.trip.T_world_vehicle = std::move(*truth);
  return std::move(collector.trip);
}

}  // namespace aisle
