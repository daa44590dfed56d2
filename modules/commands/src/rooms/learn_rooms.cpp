#include <fmt/format.h>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/taught_session.hpp"
#include "rooms/room_verbs.hpp"

namespace aisle {
namespace {

Outcome room_learning_outcome(const RoomLearningResult& learned) {
  const Route& route = learned.building.routes.front();
  const RoomRoute& room = *route.room;
  auto turnings = nlohmann::ordered_json::array();
  for (const RoomTurning& turning : room.turnings)
    turnings.push_back({{"number", turning.number},
                        {"start_m", rounded(turning.start_m, 3)},
                        {"end_m", rounded(turning.end_m, 3)}});
  Outcome outcome{.verb = "learn"};
  const std::string_view parking = parking_word(room.parking);
  outcome.figures = {{"cycles", learned.T_route_vehicle.size()},
                     {"route", route.name},
                     {"length_m", rounded(route.path.length_m(), 3)},
                     {"route_grey", rounded(room.brightness.grey, 2)},
                     {"turnings", turnings},
                     {"parking", parking}};
  outcome.text =
      fmt::format("route {}: {:.1f} m, {} turnings, route of grey level {:.0f}; parks: {}\n", route.name,
                  route.path.length_m(), room.turnings.size(), room.brightness.grey, parking);
  if (room.parking == ParkingStrategy::kView) outcome.figures["views"] = room.views.size();
  if (room.parking != ParkingStrategy::kFrame) return outcome;
  outcome.figures["frame_size_m"] = {rounded(room.frame_size_m.x(), 3), rounded(room.frame_size_m.y(), 3)};
  outcome.text +=
      fmt::format("parking frame of {:.2f} m x {:.2f} m\n", room.frame_size_m.x(), room.frame_size_m.y());
  return outcome;
}

}  // namespace

Result<Outcome> learn_by_route(const LearnOptions& options, const RoomLearnerParams& params,
                               Console& console) {
  std::vector<std::string> names = truth_file_names();
  names.emplace_back("building.json");
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, names);
  if (!directory) return directory.problems();
  const std::filesystem::path& session = options.sessions.front();
  auto cycles = SessionCycles::open(session);
  if (!cycles) return cycles.problems();
  const auto named = route_of_session(session, cycles->origin());
  if (!named) return named.problems();
  const auto run = read_room_run(session, *cycles, params, console.progress);
  if (!run) return run.problems();
  const auto learned = learn_room(*run, cycles->vehicle(), *named, params);
  if (!learned) return at_file(learned.problems(), session.string());
  Outcome outcome = room_learning_outcome(*learned);
  if (!*directory) return outcome;
  const std::vector<Pose2>& driven = learned->T_route_vehicle;
  const auto truth = true_poses(session, driven.size());
  if (!truth) return truth.problems();
  // Without truth they are empty, and replace those of an earlier, simulated run.
  std::vector<OutputFile> files = truth_files(truth->empty() ? MapTruth() : MapTruth(driven, *truth));
  files.push_back({"building", "building.json", building_json(learned->building)});
  auto written = (*directory)->write(files);
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  return outcome;
}

}  // namespace aisle
