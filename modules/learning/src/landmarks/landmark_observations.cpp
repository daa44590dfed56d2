#include "landmarks/landmark_observations.hpp"

namespace aisle {
namespace {

constexpr double kNearSigma_m = 0.02;  // of the run's poses, when pairing sightings
constexpr double kNearSigma_rad = 0.005;

}  // namespace

std::vector<LandmarkObservation> observe_landmarks(std::span<const LandmarkCycle> cycles,
                                                   const VehicleDescription& vehicle,
                                                   const LandmarkLocaliserParams& params,
                                                   std::span<const Pose2> T_map_vehicle,
                                                   std::span<const RunLandmark> landmarks) {
  LandmarkLocaliser localiser(params, vehicle, {});
  PresentLandmarks present(landmarks);
  std::vector<LandmarkObservation> all;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    localiser.place(about(T_map_vehicle[i], kNearSigma_m, kNearSigma_rad));
    if (localiser.correct(present.at(i), cycles[i].sightings) != LandmarkMatch::kMatched) continue;
    for (const LandmarkPair& pair : localiser.pairs())
      all.push_back({i, pair.sighting, present.original(pair.landmark)});
  }
  return all;
}

}  // namespace aisle
