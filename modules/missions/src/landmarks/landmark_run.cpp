#include "aisle/missions/landmarks/landmark_run.hpp"

#include <fmt/format.h>

#include "aisle/missions/taught_session.hpp"

namespace aisle {

const CameraDescription& corridor_camera(const VehicleDescription& vehicle) {
  const CameraDescription* named = vehicle.camera("corridor");
  return named == nullptr ? vehicle.cameras.front() : *named;
}

LandmarkRunCollector::LandmarkRunCollector(const LandmarkSightingParams& params,
                                           const VehicleDescription& vehicle)
    : run{.vehicle = vehicle,
          .camera = corridor_camera(vehicle),
          .cycles = {},
          .places = {},
          .T_world_vehicle = {}},
      detector_(params, run.camera.intrinsics, run.camera.mount) {}

void LandmarkRunCollector::add(const Observation& observation) {
  LandmarkCycle cycle{
      .stamp_s = observation.stamp_s, .odometry = observation.odometry, .sightings = {}, .floor_edges = {}};
  if (const CameraImage* image = present_image(observation, run.camera.name, run.vehicle.cycle_s)) {
    cycle.sightings = detector_.detect(*image->pixels);
    for (const FloorEdge& edge : detector_.floor_edges()) cycle.floor_edges.push_back(edge.on_floor);
  }
  for (const Mark& mark : observation.operator_input.marks) {
    if (mark.kind == Mark::Kind::kPlace && !mark.label.empty())
      run.places.push_back({run.cycles.size(), mark.label});
  }
  run.cycles.push_back(std::move(cycle));
}

Result<LandmarkRun> read_landmark_run(const std::filesystem::path& session, SessionCycles& cycles,
                                      const LandmarkSightingParams& params, Progress& progress) {
  if (cycles.vehicle().cameras.empty())
    return Problem{{session.string()}, "is of a vehicle without a camera"};
  LandmarkRunCollector collector(params, cycles.vehicle());
  const auto images = take_observations(session, cycles, progress,
                                        [&](const Observation& observation) { collector.add(observation); });
  if (!images) return images.problems();
  if (*images == 0) {
    return Problem{{session.string()},
                   fmt::format("has no images of the camera {}", collector.run.camera.name)};
  }
  auto truth = true_poses(session, collector.run.cycles.size());
  if (!truth) return truth.problems();
  collector.run.T_world_vehicle = std::move(*truth);
  return std::move(collector.run);
}

}  // namespace aisle
