#include "sections/section_mission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "aisle/simulation/slice.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

constexpr double kBaseLine_m = 0.02;      // height at which a wall is its base line
constexpr double kSameBaseLine_m = 0.25;  // off by more, another thing stands there
constexpr double kPictureWorthy_m = 0.5;  // shorter sections all look alike

/// The walls themselves: where there is a door, none stands.
std::vector<Segment2> base_lines_of(World world) {
  world.doors.clear();
  return slice(world, kBaseLine_m);
}

/// How far a thing stands from a point in a direction; nullopt: nothing stands there.
std::optional<double> distance_m(const Vec2& from, const Vec2& direction,
                                 const std::vector<Segment2>& walls) {
  std::optional<double> nearest_m;
  for (const Segment2& wall : walls) {
    const Vec2 along = wall.end - wall.start, gap = wall.start - from;
    const double across = cross(direction, along);
    if (across == 0) continue;
    const double ray_m = cross(gap, along) / across, share = cross(gap, direction) / across;
    if (ray_m < 0 || share < 0 || share > 1) continue;
    if (!nearest_m || ray_m < *nearest_m) nearest_m = ray_m;
  }
  return nearest_m;
}

/// Keeps the mission's session and, beside it, what it comes to.
class SectionMissionRecord final : public SimulatedRecord {
 public:
  SectionMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                       const SectionNavigator& navigator, const SimulationSetting& setting,
                       const SectionMissionOptions& options, SectionMissionResult& result)
      : SimulatedRecord(session, vehicle),
        vehicle_(vehicle),
        navigator_(navigator),
        base_lines_(base_lines_of(setting.world)),
        skirting_m_(setting.world.skirting_height_m > 0 ? kSkirtingDepth_m : 0),
        T_world_map_(options.T_world_map),
        keeps_pictures_(options.keep_pictures),
        result_(result) {}

  Result<Observation> keep(Observation observation) override {
    auto kept = SimulatedRecord::keep(std::move(observation));
    if (kept && keeps_pictures_ && !kept->pictures.empty()) last_picture_ = kept->pictures.front().image;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    result_.T_map_driven.push_back(navigator_.pose());
    show_pose({navigator_.pose()});
    if (is_watched()) show_overlay(overlay_of(navigator_.edges()));
    if (last_picture_) keep_picture();
    if (decision.state == "following") judge_distance();
    return SimulatedRecord::keep(decision);
  }

 private:
  /// The first picture behind the middle of a straight section.
  void keep_picture() {
    const PathPoint& point = navigator_.point();
    const PathPiece& piece = navigator_.path().pieces()[point.piece];
    const double middle_m = navigator_.path().start_m(point.piece) + piece.way_m() / 2;
    const bool is_worth_it = piece.arc.turn_rad == 0 && piece.way_m() > kPictureWorthy_m;
    if (!is_worth_it || point.along_m < middle_m || point.piece == pictured_piece_) return;
    pictured_piece_ = point.piece;
    result_.pictures.push_back({*last_picture_, fmt::format("section {}", navigator_.guide().section + 1)});
  }

  void judge_distance() {
    const auto learned_m = navigator_.guide().right_m;
    if (!learned_m) return;
    const double right_rad = T_world_map_.theta + navigator_.point().T_map_path.theta - kPi / 2;
    const auto wall_m = distance_m(vehicle_.truth().T_world_vehicle.position(), unit(right_rad), base_lines_);
    if (!wall_m) return;
    const double off_m = *wall_m - skirting_m_ - *learned_m;
    if (std::abs(off_m) > kSameBaseLine_m) return;
    result_.wall_distance_m.add(off_m);
  }

  const SimulatedVehicle& vehicle_;
  const SectionNavigator& navigator_;
  std::vector<Segment2> base_lines_;
  double skirting_m_;
  Pose2 T_world_map_;
  bool keeps_pictures_;
  SectionMissionResult& result_;
  std::shared_ptr<const Image> last_picture_;
  std::optional<std::size_t> pictured_piece_;
};

}  // namespace

Result<SectionMissionResult> drive_section_mission(const SimulationSetting& setting,
                                                   SectionNavigator& navigator,
                                                   const SectionMissionOptions& options,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  const Pose2 T_map_start = navigator.path().at(0).T_map_path,
              T_map_end = navigator.path().pieces().back().end();
  const Pose2 T_world_set_down = set_down(
      setting, about(options.T_world_map * T_map_start, options.start_sigma_m, options.start_sigma_rad),
      options.seed);
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = options.seed, .T_world_start = T_world_set_down});
  SectionMissionResult result;
  TimedNavigator timed(navigator, result.cycle_s);
  SectionMissionRecord record(session, vehicle, navigator, setting, options, result);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  result.end = std::move(*end);
  result.collisions = vehicle.truth().collisions;
  result.distance_m = vehicle.truth().way_m;
  const Pose2 T_world_due = navigator.comes_home() ? T_world_set_down * between(T_map_start, T_map_end)
                                                   : options.T_world_map * T_map_end;
  const Pose2 off = between(T_world_due, vehicle.truth().T_world_vehicle);
  result.closing_error_m = off.position().norm();
  result.closing_error_rad = std::abs(off.theta);
  return result;
}

nlohmann::ordered_json figures_of(const SectionMissionResult& result) {
  return {{"arrived", result.end.arrived},
          {"state", result.end.state},
          {"why", result.end.why},
          {"collisions", result.collisions},
          {"distance_m", rounded(result.distance_m, 3)},
          {"duration_s", rounded(result.end.duration_s, 3)},
          {"closing_error_m", rounded(result.closing_error_m, 4)},
          {"closing_error_deg", rounded(to_degrees(result.closing_error_rad), 3)},
          {"wall_distance_rmse_m", rounded(result.wall_distance_m.rms(), 4)},
          {"cycle_ms", cycle_figures(result.cycle_s)}};
}

}  // namespace aisle
