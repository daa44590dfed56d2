#include "aisle/guidance/landmarks/scene_monitor.hpp"

#include "landmarks/same_lines.hpp"

namespace aisle {
namespace {

constexpr SceneJump<LandmarkSighting>::Limits kScenes{
    .compared_min = 5, .other_share_max = 0.2, .same_share_min = 0.5};

}  // namespace

void SceneMonitor::move(const Pose2& T_before_now) {
  jump_.move(T_before_now, carry_sightings);
}

bool SceneMonitor::look(std::span<const LandmarkSighting> image, bool is_known_here) {
  return jump_.look(image, is_known_here, kScenes, shown_share);
}

}  // namespace aisle
