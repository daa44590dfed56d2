#include "sections/section_mission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "rounded.hpp"
#include "sections/wall_keeping.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

constexpr double kPictureWorthy_m = 0.5;  // shorter sections all look the same

/// Records the mission's session, and collects the mission's result.
class SectionMissionRecord final : public SimulatedRecord {
 public:
  SectionMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                       const SectionNavigator& navigator, const SimulationSetting& setting,
                       const SectionMissionOptions& options, SectionMissionResult& result)
      : SimulatedRecord(session, vehicle),
        vehicle_(vehicle),
        navigator_(navigator),
        wall_keeping_(setting.world),
        T_world_map_(options.T_world_map),
        keeps_images_(options.keep_images),
        result_(result) {}

  Result<Observation> keep(Observation observation) override {
    auto kept = SimulatedRecord::keep(std::move(observation));
    if (kept && keeps_images_ && !kept->images.empty()) last_image_ = kept->images.front().pixels;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    result_.T_map_driven.push_back(navigator_.pose());
    show_pose({navigator_.pose()});
    if (is_watched()) show_overlay(overlay_of(navigator_.edges()));
    if (last_image_) keep_image();
    if (decision.state == "following") judge_distance();
    return SimulatedRecord::keep(decision);
  }

  ErrorFigure wall_distance_m() const { return wall_keeping_.error_m(); }

 private:
  /// Keeps the first image after the middle of a straight section.
  void keep_image() {
    const PathPoint& point = navigator_.point();
    const PathPiece& piece = navigator_.path().pieces()[point.piece];
    const double middle_m = navigator_.path().start_m(point.piece) + piece.path_m() / 2;
    const bool is_worth_it = piece.arc.turn_rad == 0 && piece.path_m() > kPictureWorthy_m;
    if (!is_worth_it || point.along_m < middle_m || point.piece == pictured_piece_) return;
    pictured_piece_ = point.piece;
    result_.images.push_back({*last_image_, fmt::format("section {}", navigator_.guide().section + 1)});
  }

  void judge_distance() {
    const auto learned_m = navigator_.guide().right_m;
    if (!learned_m) return;
    const PathPoint& point = navigator_.point();
    const Vec2 p_world = vehicle_.truth().T_world_vehicle.position();
    wall_keeping_.add(point.piece, {p_world.x(), p_world.y(), T_world_map_.theta + point.T_map_path.theta},
                      *learned_m);
  }

  const SimulatedVehicle& vehicle_;
  const SectionNavigator& navigator_;
  WallKeeping wall_keeping_;
  Pose2 T_world_map_;
  bool keeps_images_;
  SectionMissionResult& result_;
  std::shared_ptr<const Image> last_image_;
  std::optional<std::size_t> pictured_piece_;
};

}  // namespace

Result<SectionMissionResult> drive_section_mission(const SimulationSetting& setting,
                                                   SectionNavigator& navigator,
                                                   const SectionMissionOptions& options,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  const Pose2 T_map_start = navigator.path().at(0).T_map_path, T_map_end = navigator.path().end();
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
  result.distance_m = vehicle.truth().path_m;
  result.wall_distance_m = record.wall_distance_m();
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
