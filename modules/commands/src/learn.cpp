#include "aisle/commands/learn.hpp"

#include <fmt/format.h>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "landmarks/landmark_lesson.hpp"
#include "learned_files.hpp"
#include "methods.hpp"
#include "rooms/room_verbs.hpp"
#include "rounded.hpp"
#include "sections/section_verbs.hpp"
#include "sessions/session_trip.hpp"

namespace aisle {
namespace {

struct LearnParams {
  LandmarkLessonParams landmarks;
  SectionLessonParams sections;
  RoomLessonParams route;

  void describe(FieldList& fields) {
    landmarks.describe(fields);
    fields.group("sections", sections);
    fields.group("route", route);
  }
};

Outcome outcome_of(const LandmarkTrip& trip, const LandmarkLesson& lesson) {
  const Route& route = lesson.building.routes.front();
  std::size_t pictures = 0, sightings = 0;
  for (const LandmarkCycle& cycle : trip.cycles) {
    pictures += cycle.sightings.empty() ? 0 : 1;
    sightings += cycle.sightings.size();
  }
  Outcome outcome{.verb = "learn"};
  outcome.figures = {{"cycles", trip.cycles.size()},
                     {"pictures_with_landmarks", pictures},
                     {"sightings", sightings},
                     {"landmarks", lesson.building.landmarks.size()},
                     {"route", route.name},
                     {"length_m", rounded(route.path.length_m(), 3)},
                     {"pieces", route.path.pieces().size()}};
  outcome.text = fmt::format(
      "learned {} landmarks from {} sightings in {} pictures\n"
      "route {}: {:.1f} m in {} lines and arcs\n",
      lesson.building.landmarks.size(), sightings, pictures, route.name, route.path.length_m(),
      route.path.pieces().size());
  return outcome;
}

std::vector<Vec2> feet_on_map(const LandmarkTrip& trip, const std::vector<Pose2>& T_map_taught) {
  std::vector<Vec2> feet;
  for (std::size_t i = 0; i < trip.cycles.size(); ++i) {
    for (const LandmarkSighting& sighting : trip.cycles[i].sightings)
      feet.push_back(T_map_taught[i] * sighting.p_vehicle);
  }
  return feet;
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
    return Problem{{options.sessions[1].string()}, "is one too many: by sections alone several are learned"};
  if (options.method == "route") return learn_by_route(options, all.route, console);
  const LandmarkLessonParams& params = all.landmarks;
  const std::filesystem::path& session = options.sessions.front();
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, learned_file_names());
  if (!directory) return directory.problems();
  auto cycles = SessionCycles::open(session);
  if (!cycles) return cycles.problems();
  const auto named = route_of_session(session, cycles->origin());
  if (!named) return named.problems();
  const auto trip = read_landmark_trip(session, *cycles, params.sightings, console.progress);
  if (!trip) return trip.problems();
  const auto lesson = learn_lesson(*trip, *named, params);
  if (!lesson) return at_file(lesson.problems(), session.string());
  Outcome outcome = outcome_of(*trip, *lesson);
  if (!*directory) return outcome;
  auto files =
      (*directory)
          ->write(learned_files(lesson->building, MapTruth(lesson->T_map_taught, trip->T_world_vehicle),
                                feet_on_map(*trip, lesson->T_map_taught)));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  outcome.figures["building_bytes"] = building_json(lesson->building).size();
  return outcome;
}

}  // namespace aisle
