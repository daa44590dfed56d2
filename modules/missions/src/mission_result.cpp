#include "aisle/missions/mission_result.hpp"

#include <fmt/format.h>

#include <utility>

#include "timed_navigator.hpp"

namespace aisle {

Problems drive_mission(Vehicle& vehicle, const TruthSource* truth, Navigator& navigator,
                       MissionRecorder& record, Progress& progress, MissionResult& result) {
  TimedNavigator timed(navigator, result.cycle_s);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  result.end = std::move(*end);
  result.odometry_m = record.odometry_m();
  if (truth != nullptr) result.truth = truth->truth();
  return {};
}

std::string collisions_text(const MissionResult& result) {
  const auto collisions = result.collisions();
  return collisions ? fmt::format(", {} collision{}", *collisions, *collisions == 1 ? "" : "s") : "";
}

std::string mission_text(const MissionResult& result) {
  return fmt::format("{}{}{}{}; {:.1f} m in {:.1f} s{}", result.is_simulated() ? "simulated: " : "",
                     result.end.state, result.end.why.empty() ? "" : ": ", result.end.why,
                     result.distance_m(), result.end.duration_s, collisions_text(result));
}

nlohmann::ordered_json known_figures(nlohmann::ordered_json figures) {
  for (auto figure = figures.begin(); figure != figures.end();)
    figure = figure->is_null() ? figures.erase(figure) : std::next(figure);
  return figures;
}

}  // namespace aisle
