#pragma once
/// Runs through the shipped worlds, recorded by the simulator, and the maps learned from them.

#include <stdexcept>
#include <string>

#include "aisle/core/random.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/learning/walls/published_mapping.hpp"
#include "aisle/learning/walls/relation_error.hpp"
#include "aisle/simulation/operators/tour_recorder.hpp"
#include "aisle/simulation/operators/true_relations.hpp"

namespace aisle {

inline TourRecording recorded(const std::string& world_name, const TourParams& params = {},
                              std::uint64_t seed = 1) {
  const auto world = read_world(AISLE_SOURCE_DIR "/worlds/" + world_name + ".yaml");
  if (!world) throw std::runtime_error(to_string(world.problems()));
  SilentProgress progress;
  return record_tour(*world, params, seed, progress);
}

inline MapResult mapped(const LaserLog& log) {
  SilentProgress progress;
  return build_map(log, MapParams{}, {}, false, progress);
}

inline MapResult mapped_as_published(const LaserLog& log) {
  SilentProgress progress;
  return build_published_map(log, SegmentParams{}, PublishedParams{}, 0, progress);
}

/// Mean error of a trajectory over the true relative poses of its run.
inline double error_m(const std::vector<Pose2>& T_map_vehicle, const TourRecording& run) {
  Random random(1);
  return relation_error(T_map_vehicle, true_relations(run.T_world_vehicle, random)).translation_m.mean;
}

}  // namespace aisle
