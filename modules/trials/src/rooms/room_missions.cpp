#include "rooms/room_missions.hpp"

#include <optional>
#include <utility>

#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"

namespace aisle {
namespace {

constexpr double kFalseStop_m = 0.5;  // a vehicle that parks farther away has taken another place for this

}  // namespace

SimulationSetting on_another_day(SimulationSetting setting, const RoomChange& change, Random& random) {
  for (Furniture& piece : setting.world.furniture) {
    piece.centre.x() += random.uniform(-change.furniture_m, change.furniture_m);
    piece.centre.y() += random.uniform(-change.furniture_m, change.furniture_m);
  }
  LightChange& change_of_light = setting.scenario.events.emplace_back().fault.emplace<LightChange>();
  change_of_light.light = 1 + random.uniform(-change.light_share, change.light_share);
  return setting;
}

nlohmann::ordered_json room_record(const JudgedRoomMission& judged, std::uint64_t seed,
                                   const std::string& route) {
  const RoomMissionResult& result = judged.mission;
  const RoomErrors& errors = *judged.errors;
  const bool is_at_place = errors.end_m < kFalseStop_m;
  const bool has_arrived = result.parked() && is_at_place;
  nlohmann::ordered_json run = {{"seed", seed}, {"route", route}};
  run.update(figures_of(judged));
  return {{"ok", has_arrived},
          {"run", run},
          {"counted",
           {{"arrived", has_arrived},
            {"ended", result.end.arrived},
            {"false_stop", result.end.arrived && !is_at_place},
            {"stopped", !result.end.arrived && result.is_unharmed()},
            {"collisions", result.truth->collisions},
            {"end_m", errors.end_m},
            {"end_deg", to_degrees(errors.end_rad)},
            {"clearance_m", errors.clearance_m},
            {"cycle_s", result.cycle_s}}}};
}

void RoomTrial::add(const nlohmann::ordered_json& record) {
  if (not_taught.add(record)) return;
  const nlohmann::ordered_json& counted = record.at("counted");
  const auto count = [&](const char* what) { return counted.at(what).get<bool>() ? 1U : 0U; };
  ++missions;
  arrived += count("arrived");
  false_stops += count("false_stop");
  stopped += count("stopped");
  collisions += counted.at("collisions").get<std::size_t>();
  if (counted.at("ended").get<bool>()) {
    end_m.add(counted.at("end_m"));
    end_deg.add(counted.at("end_deg"));
    clearance_m.add(counted.at("clearance_m"));
  }
  for (const nlohmann::ordered_json& one_s : counted.at("cycle_s")) cycle_s.push_back(one_s);
  runs.push_back(record.at("run"));
  auto& [good, driven] = by_route[runs.back().at("route")];
  good += count("arrived");
  ++driven;
}

Result<JudgedRoomMission> drive_taught(SimulationSetting setting, const TaughtRoute& taught,
                                       const RoomNavigatorParams& params, std::uint64_t seed,
                                       const Pose2& T_world_start, double from_m, Progress& progress) {
  VehicleDescription& vehicle = setting.vehicle.description;
  const ParkingStrategy parking = taught.route.room->parking;
  RoomNavigator navigator(params, vehicle, taught.route, from_m);
  keep_cameras(vehicle, cameras_for(taught.route));
  SimulatedVehicle driven = vehicle_in(setting, T_world_start, 1000 * (seed + 1));
  std::optional<SessionRecord> no_session;
  auto mission = drive_room_mission(driven, &driven, navigator, no_session, progress);
  if (!mission) return mission.problems();
  return judged(
      std::move(*mission), setting.world, vehicle.footprint,
      due_end(setting.world, vehicle.footprint, parking, taught.place.end(), params.frame_backing.wanted));
}

}  // namespace aisle
