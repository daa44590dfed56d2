#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "aisle/guidance/mission.hpp"
#include "aisle/missions/mission_recorder.hpp"
#include "aisle/vehicle/truth_source.hpp"

namespace aisle {

/// What every mission reports, whatever it drives by.
struct MissionResult {
  MissionEnd end;
  std::optional<Truth> truth;   ///< at the end; nullopt: the vehicle is not simulated
  double odometry_m = 0;        ///< distance travelled, as the wheels counted it
  std::vector<double> cycle_s;  ///< processor time of each cycle, from observation to command

  bool is_simulated() const { return truth.has_value(); }
  /// nullopt: unknown.
  std::optional<std::size_t> collisions() const {
    return truth ? std::optional(truth->collisions) : std::nullopt;
  }
  /// Distance travelled: the true one where it is known.
  double distance_m() const { return truth ? truth->path_m : odometry_m; }
  /// Whether no collision is known.
  bool is_unharmed() const { return !truth || truth->collisions == 0; }
};

/// Lets a navigator drive a vehicle until its mission ends, and fills in what every mission reports.
/// @param truth  of the vehicle; null: unknown
/// @return problems of the record; empty: none
Problems drive_mission(Vehicle& vehicle, const TruthSource* truth, Navigator& navigator,
                       MissionRecorder& record, Progress& progress, MissionResult& result);

/// "simulated: arrived; 12.3 m in 45.6 s, 0 collisions": without what is unknown.
std::string mission_text(const MissionResult& result);

/// ", 1 collision"; empty if it is unknown.
std::string collisions_text(const MissionResult& result);

/// A figure; null: unknown.
template <class Value>
nlohmann::ordered_json if_known(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// The figures without those that are null: unknown.
nlohmann::ordered_json known_figures(nlohmann::ordered_json figures);

}  // namespace aisle
