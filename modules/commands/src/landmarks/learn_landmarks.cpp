#include <fmt/format.h>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/taught_session.hpp"
#include "landmarks/landmark_verbs.hpp"

namespace aisle {
namespace {

Outcome landmark_learning_outcome(const LandmarkRun& run, const LandmarkLearningResult& learned) {
  const Route& route = learned.building.routes.front();
  std::size_t images = 0, sightings = 0;
  for (const LandmarkCycle& cycle : run.cycles) {
    images += cycle.sightings.empty() ? 0 : 1;
    sightings += cycle.sightings.size();
  }
  Outcome outcome{.verb = "learn"};
  outcome.figures = {{"cycles", run.cycles.size()},
                     {"pictures_with_landmarks", images},
                     {"sightings", sightings},
                     {"landmarks", learned.building.landmarks.size()},
                     {"route", route.name},
                     {"length_m", rounded(route.path.length_m(), 3)},
                     {"pieces", route.path.pieces().size()}};
  outcome.text = fmt::format(
      "learned {} landmarks from {} sightings in {} images\n"
      "route {}: {:.1f} m in {} lines and arcs\n",
      learned.building.landmarks.size(), sightings, images, route.name, route.path.length_m(),
      route.path.pieces().size());
  return outcome;
}

std::vector<Vec2> floor_points_on_map(const LandmarkRun& run, const std::vector<Pose2>& T_map_taught) {
  std::vector<Vec2> floor_points;
  for (std::size_t i = 0; i < run.cycles.size(); ++i) {
    for (const LandmarkSighting& sighting : run.cycles[i].sightings)
      floor_points.push_back(T_map_taught[i] * sighting.p_vehicle);
  }
  return floor_points;
}

}  // namespace

Result<Outcome> learn_by_landmarks(const LearnOptions& options, const LandmarkLearnerParams& params,
                                   Console& console) {
  const std::filesystem::path& session = options.sessions.front();
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, learned_file_names());
  if (!directory) return directory.problems();
  auto cycles = SessionCycles::open(session);
  if (!cycles) return cycles.problems();
  const auto named = route_of_session(session, cycles->origin());
  if (!named) return named.problems();
  const auto run = read_landmark_run(session, *cycles, params.sightings, console.progress);
  if (!run) return run.problems();
  const auto learned = learn_route(*run, *named, params);
  if (!learned) return at_file(learned.problems(), session.string());
  Outcome outcome = landmark_learning_outcome(*run, *learned);
  if (!*directory) return outcome;
  auto files =
      (*directory)
          ->write(learned_files(learned->building, MapTruth(learned->T_map_taught, run->T_world_vehicle),
                                floor_points_on_map(*run, learned->T_map_taught)));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  outcome.figures["building_bytes"] = building_json(learned->building).size();
  return outcome;
}

}  // namespace aisle
