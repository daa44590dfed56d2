#include <fmt/format.h>

#include "aisle/commands/output_directory.hpp"
#include "aisle/formats/building_json.hpp"
#include "aisle/formats/section_text.hpp"
#include "aisle/formats/session_truth.hpp"
#include "aisle/report/section_picture.hpp"
#include "learned_files.hpp"
#include "rounded.hpp"
#include "route_name.hpp"
#include "section_verbs.hpp"

namespace aisle {
namespace {

constexpr const char* kSectionsPicture = "sections.svg";

nlohmann::ordered_json texts_of(const SectionList& sections) {
  auto texts = nlohmann::ordered_json::array();
  for (const Section& section : sections) texts.push_back(section_text(section));
  return texts;
}

Outcome section_lesson_outcome(const SectionLesson& lesson) {
  const Route& route = lesson.building.routes.front();
  Outcome outcome{.verb = "learn"};
  outcome.figures = {{"cycles", lesson.driven.T_route_vehicle.size()},
                     {"route", route.name},
                     {"length_m", rounded(route.path.length_m(), 3)},
                     {"recorded", texts_of(lesson.driven.sections)},
                     {"sections", texts_of(route.sections)}};
  if (lesson.driven.corridor_width_m)
    outcome.figures["corridor_width_m"] = rounded(*lesson.driven.corridor_width_m, 3);
  outcome.text = fmt::format("route {}: {:.1f} m in {} sections\n", route.name, route.path.length_m(),
                             route.sections.size());
  for (const Section& section : route.sections) outcome.text += "  " + section_text(section) + "\n";
  return outcome;
}

}  // namespace

Result<Outcome> learn_by_sections(const LearnOptions& options, const SectionLessonParams& params,
                                  Console& console) {
  std::optional<OutputDirectory> directory;
  if (!options.out.empty()) {
    std::vector<std::string> names = truth_file_names();
    names.insert(names.end(), {"building.json", kSectionsPicture});
    auto opened = OutputDirectory::open(options.out, options.force, names);
    if (!opened) return opened.problems();
    directory = std::move(*opened);
  }
  auto cycles = SessionCycles::open(options.session);
  if (!cycles) return cycles.problems();
  const std::string named = cycles->origin().route.empty() ? "route" : cycles->origin().route;
  if (Problems problems = check_route_name({options.session.string(), 0, "route"}, named); !problems.empty())
    return problems;
  const auto trip = read_section_trip(options.session, *cycles, params.floor_edges, console.progress);
  if (!trip) return trip.problems();
  const auto lesson = learn_sections(*trip, cycles->vehicle(), named, params);
  if (!lesson) return at_file(lesson.problems(), options.session.string());
  Outcome outcome = section_lesson_outcome(*lesson);
  if (!directory) return outcome;
  const auto truth = read_true_poses(options.session);
  if (!truth) return truth.problems();
  std::vector<OutputFile> files;
  if (truth->T_map_vehicle.size() == lesson->driven.T_route_vehicle.size())
    files = truth_files(MapTruth(lesson->driven.T_route_vehicle, truth->T_map_vehicle));
  files.push_back({"building", "building.json", building_json(lesson->building)});
  files.push_back({"sections_svg", kSectionsPicture,
                   svg(SectionPicture{.route = lesson->building.routes.front(),
                                      .driven = lesson->driven.T_route_vehicle,
                                      .title = fmt::format("{}: sections as learned", named)})});
  auto written = directory->write(files);
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  return outcome;
}

}  // namespace aisle
