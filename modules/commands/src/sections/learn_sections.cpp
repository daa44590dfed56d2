#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/output_directory.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/report/section_picture.hpp"
#include "learned_files.hpp"
#include "rounded.hpp"
#include "sections/section_verbs.hpp"
#include "sessions/session_trip.hpp"

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

struct SectionTeachings {
  std::string route;  ///< as the first one names it
  std::vector<DrivenList> drives;
};

Result<SectionTeachings> read_teachings(const std::vector<std::filesystem::path>& sessions,
                                        const SectionLessonParams& params, Progress& progress) {
  SectionTeachings teachings;
  for (const std::filesystem::path& session : sessions) {
    auto cycles = SessionCycles::open(session);
    if (!cycles) return cycles.problems();
    auto route = route_of_session(session, cycles->origin());
    if (!route) return route.problems();
    if (teachings.drives.empty()) teachings.route = std::move(*route);
    auto drive = read_section_drive(session, *cycles, params, progress);
    if (!drive) return drive.problems();
    teachings.drives.push_back(std::move(*drive));
  }
  return teachings;
}

void warn_of_other_ways(const std::vector<std::filesystem::path>& sessions,
                        const std::vector<std::size_t>& taken, Console& console) {
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (!std::binary_search(taken.begin(), taken.end(), i))
      console.warn(
          fmt::format("{}: goes another way than the other sessions, and is left out", sessions[i].string()));
  }
}

}  // namespace

Result<Outcome> learn_by_sections(const LearnOptions& options, const SectionLessonParams& params,
                                  Console& console) {
  std::vector<std::string> names = truth_file_names();
  names.insert(names.end(), {"building.json", kSectionsPicture});
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, names);
  if (!directory) return directory.problems();
  const auto taught = read_teachings(options.sessions, params, console.progress);
  if (!taught) return taught.problems();
  const auto lesson = learn_sections(taught->drives, taught->route, params.learning);
  if (!lesson) return at_file(lesson.problems(), options.sessions.front().string());
  warn_of_other_ways(options.sessions, lesson->taken, console);
  Outcome outcome = section_lesson_outcome(*lesson);
  if (const auto why = gets_lost(*lesson, params.learning)) {
    outcome.ok = false;
    outcome.figures["why"] = *why;
    outcome.text = *why + '\n';
    return outcome;
  }
  if (options.sessions.size() > 1) outcome.figures["teachings"] = lesson->taken.size();
  if (!*directory) return outcome;
  const std::vector<Pose2>& driven = lesson->driven.T_route_vehicle;
  const auto truth = true_poses(options.sessions[lesson->taken.front()], driven.size());
  if (!truth) return truth.problems();
  std::vector<OutputFile> files;
  if (!truth->empty()) files = truth_files(MapTruth(driven, *truth));
  files.push_back({"building", "building.json", building_json(lesson->building)});
  files.push_back({"sections_svg", kSectionsPicture,
                   svg(SectionPicture{.route = lesson->building.routes.front(),
                                      .driven = driven,
                                      .title = fmt::format("{}: sections as learned", taught->route)})});
  auto written = (*directory)->write(files);
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  return outcome;
}

}  // namespace aisle
