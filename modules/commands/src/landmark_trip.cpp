#include "landmark_trip.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/formats/session_truth.hpp"

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
  LandmarkCycle cycle{.stamp_s = observation.stamp_s, .odometry = observation.odometry, .sightings = {}};
  if (const CameraPicture* picture = present_picture(observation, trip.camera.name, trip.vehicle.cycle_s))
    cycle.sightings = detector_.detect(*picture->image);
  trip.cycles.push_back(std::move(cycle));
}

Result<LandmarkTrip> read_landmark_trip(const std::filesystem::path& session, SessionCycles& cycles,
                                        const LandmarkSightingParams& params, Progress& progress) {
  if (cycles.vehicle().cameras.empty())
    return Problem{{session.string()}, "is of a vehicle without a camera"};
  LandmarkTripCollector collector(params, cycles.vehicle());
  std::size_t pictures = 0;
  while (true) {
    auto cycle = cycles.next();
    if (!cycle) return cycle.problems();
    if (!cycle->has_value()) break;
    pictures += (*cycle)->observation.pictures.size();
    collector.add((*cycle)->observation);
    progress.report("looking at pictures", pictures, 0);
  }
  if (collector.trip.cycles.empty()) return Problem{{session.string()}, "has no cycles"};
  if (pictures == 0) {
    return Problem{{session.string()},
                   fmt::format("has no pictures of the camera {}", collector.trip.camera.name)};
  }
  auto truth = read_true_poses(session);
  if (!truth) return truth.problems();
  if (truth->T_map_vehicle.size() == collector.trip.cycles.size())
    collector.trip.T_world_vehicle = std::move(truth->T_map_vehicle);
  return std::move(collector.trip);
}

}  // namespace aisle
