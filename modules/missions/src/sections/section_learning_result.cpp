#include "aisle/missions/sections/section_learning_result.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/missions/taught_session.hpp"

namespace aisle {

SectionRunCollector::SectionRunCollector(const FloorEdgeParams& params, const VehicleDescription& vehicle)
    : vehicle_(vehicle),
      camera_(corridor_camera(vehicle).name),
      detector_(params, corridor_camera(vehicle).intrinsics, corridor_camera(vehicle).mount) {}

void SectionRunCollector::add(const Observation& observation) {
  SectionCycle cycle{.stamp_s = observation.stamp_s, .odometry = observation.odometry, .floor_edges = {}};
  if (const CameraImage* image = present_image(observation, camera_, vehicle_.cycle_s)) {
    for (const FloorEdge& edge : detector_.detect(*image->pixels)) cycle.floor_edges.push_back(edge.on_floor);
  }
  cycles.push_back(std::move(cycle));
}

Result<DrivenList> read_section_drive(const std::filesystem::path& session, SessionCycles& cycles,
                                      const SectionLearnerParams& params, Progress& progress) {
  if (cycles.vehicle().cameras.empty())
    return Problem{{session.string()}, "is of a vehicle without a camera"};
  SectionRunCollector collector(params.floor_edges, cycles.vehicle());
  const auto images = take_observations(session, cycles, progress,
                                        [&](const Observation& observation) { collector.add(observation); });
  if (!images) return images.problems();
  if (*images == 0) return Problem{{session.string()}, "has no images"};
  return record_drive(collector.cycles, cycles.vehicle(), params.learning);
}

Result<SectionLearningResult> learn_sections(std::span<const DrivenList> drives, const std::string& route,
                                             const SectionLearningParams& params) {
  MergedDrives merged = merge_drives(drives);
  SectionLearningResult result{
      .building = {}, .driven = std::move(merged.driven), .taken = std::move(merged.taken)};
  if (result.driven.sections.empty()) return Problem{{}, "the vehicle stood still all the time"};
  Route learned{.name = route,
                .sections = decide_sections(result.driven.sections, result.driven.corridor_width_m, params)};
  Problems problems;
  for (const SectionFault& fault : section_faults(learned.sections)) {
    problems.push_back({{},
                        fmt::format("section {} ({}): {}", fault.section + 1,
                                    section_text(learned.sections[fault.section]), fault.what)});
  }
  if (!problems.empty()) return problems;
  learned.path = path_of(learned.sections, result.driven.T_route_start);
  result.building.name = route;
  result.building.routes.push_back(std::move(learned));
  return result;
}

std::optional<std::string> gets_lost(const SectionLearningResult& result,
                                     const SectionLearningParams& params) {
  const UnseenPathSegment& unseen = result.driven.unseen;
  if (unseen.length_m <= params.unseen_max_m) return std::nullopt;
  return fmt::format(
      "no wall-floor edge was seen for {:.1f} m, from {:.1f} m after the start: a vehicle would get lost "
      "there. Drive nearer to a wall, add light, or give walls and skirting boards another brightness than "
      "the floor",
      unseen.length_m, unseen.from_m);
}

}  // namespace aisle
