#include "aisle/evaluation/sections/section_evaluation.hpp"

#include <cmath>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/missions/statistics.hpp"
#include "sections/wall_keeping.hpp"

namespace aisle {
namespace {

/// Due end pose: the start again if the vehicle drives back home.
Pose2 section_due_end(const SectionNavigator& navigator, const SectionPlace& place) {
  const Pose2 T_map_start = navigator.path().at(0).T_map_path, T_map_end = navigator.path().end();
  return navigator.comes_home() ? place.T_world_start * between(T_map_start, T_map_end)
                                : place.T_world_map * T_map_end;
}

}  // namespace

JudgedSectionMission judged(SectionMissionResult mission, const SectionNavigator& navigator,
                            const SectionPlace& place) {
  if (!mission.is_simulated()) return {std::move(mission), std::nullopt};
  WallKeeping keeping(place.world);
  for (const FollowedEdge& edge : mission.followed) {
    const Vec2 p_world = edge.T_world_vehicle.position();
    keeping.add(edge.piece, {p_world.x(), p_world.y(), place.T_world_map.theta + edge.heading_rad},
                edge.learned_m);
  }
  const Pose2 off = between(section_due_end(navigator, place), mission.truth->T_world_vehicle);
  return {std::move(mission), SectionErrors{.closing_m = off.position().norm(),
                                            .closing_rad = std::abs(off.theta),
                                            .wall_distance_m = keeping.error_m()}};
}

nlohmann::ordered_json figures_of(const JudgedSectionMission& judged) {
  const SectionMissionResult& mission = judged.mission;
  nlohmann::ordered_json closing_m, closing_deg, wall_m;
  if (judged.errors) {
    closing_m = rounded(judged.errors->closing_m, 4);
    closing_deg = rounded(to_degrees(judged.errors->closing_rad), 3);
    wall_m = rounded(judged.errors->wall_distance_m.rms(), 4);
  }
  return known_figures({{"arrived", mission.end.arrived},
                        {"state", mission.end.state},
                        {"why", mission.end.why},
                        {"collisions", if_known(mission.collisions())},
                        {"distance_m", rounded(mission.distance_m(), 3)},
                        {"duration_s", rounded(mission.end.duration_s, 3)},
                        {"closing_error_m", closing_m},
                        {"closing_error_deg", closing_deg},
                        {"wall_distance_rmse_m", wall_m},
                        {"cycle_ms", cycle_figures(mission.cycle_s)}});
}

}  // namespace aisle
