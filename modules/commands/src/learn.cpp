#include "aisle/commands/learn.hpp"

#include <fmt/format.h>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/methods.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/landmarks/landmark_learning_result.hpp"
#include "aisle/missions/taught_session.hpp"
#include "rooms/room_verbs.hpp"
#include "sections/section_verbs.hpp"

namespace aisle {
namespace {

struct LearnParams {
  LandmarkLearnerParams landmarks;
  SectionLearnerParams sections;
  RoomLearnerParams route;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    fields.group("sections", sections);
    fields.group("route", route);
  }
};

Outcome outcome_of(const LandmarkRun& run, const LandmarkLearningResult& learned) {
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

Outcome learn_parameters() {
  LearnParams params;
  return parameter_listing("learn", fields_of(params));
}

Result<Outcome> run_learn(const LearnOptions& options, Console& console) {
  if (Problems problems = check_method(options.method); !problems.empty()) return problems;
  LearnParams all;
  FieldList fields = fields_of(all);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.method == "sections") return learn_by_sections(options, all.sections, console);
  if (options.sessions.size() > 1)
    return Problem{{options.sessions[1].string()},
                   "is one session too many: only --method sections learns from several"};
  if (options.method == "route") return learn_by_route(options, all.route, console);
  const LandmarkLearnerParams& params = all.landmarks;
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
  Outcome outcome = outcome_of(*run, *learned);
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
