#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/missions/taught_session.hpp"
#include "aisle/report/section_picture.hpp"
#include "sections/section_verbs.hpp"

namespace aisle {
namespace {

constexpr const char* kSectionsPicture = "sections.svg";

nlohmann::ordered_json texts_of(const SectionList& sections) {
  auto texts = nlohmann::ordered_json::array();
  for (const Section& section : sections) texts.push_back(section_text(section));
  return texts;
}

Outcome section_learning_outcome(const SectionLearningResult& learned) {
  const Route& route = learned.building.routes.front();
  Outcome outcome{.verb = "learn"};
  outcome.figures = {{"cycles", learned.driven.T_route_vehicle.size()},
                     {"route", route.name},
                     {"length_m", rounded(route.path.length_m(), 3)},
                     {"recorded", texts_of(learned.driven.sections)},
                     {"sections", texts_of(route.sections)}};
  if (learned.driven.corridor_width_m)
    outcome.figures["corridor_width_m"] = rounded(*learned.driven.corridor_width_m, 3);
  outcome.text = fmt::format("route {}: {:.1f} m in {} sections\n", route.name, route.path.length_m(),
                             route.sections.size());
  for (const Section& section : route.sections) outcome.text += "  " + section_text(section) + "\n";
  return outcome;
}

struct SectionTeachings {
  std::string route;  ///< name from the first session
  std::vector<DrivenList> drives;
};

Result<SectionTeachings> read_teachings(const std::vector<std::filesystem::path>& sessions,
                                        const SectionLearnerParams& params, Progress& progress) {
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

void warn_of_other_paths(const std::vector<std::filesystem::path>& sessions,
                         const std::vector<std::size_t>& taken, Console& console) {
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (!std::binary_search(taken.begin(), taken.end(), i))
      console.warn(fmt::format("{}: follows another path than the other sessions, and is left out",
                               sessions[i].string()));
  }
}

}  // namespace

Result<Outcome> learn_by_sections(const LearnOptions& options, const SectionLearnerParams& params,
                                  Console& console) {
  std::vector<std::string> names = truth_file_names();
  names.insert(names.end(), {"building.json", kSectionsPicture});
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, names);
  if (!directory) return directory.problems();
  const auto taught = read_teachings(options.sessions, params, console.progress);
  if (!taught) return taught.problems();
  const auto learned = learn_sections(taught->drives, taught->route, params.learning);
  if (!learned) return at_file(learned.problems(), options.sessions.front().string());
  warn_of_other_paths(options.sessions, learned->taken, console);
  Outcome outcome = section_learning_outcome(*learned);
  if (const auto why = gets_lost(*learned, params.learning)) {
    outcome.ok = false;
    outcome.figures["why"] = *why;
    outcome.text = *why + '\n';
    return outcome;
  }
  if (options.sessions.size() > 1) outcome.figures["teachings"] = learned->taken.size();
  if (!*directory) return outcome;
  const std::vector<Pose2>& driven = learned->driven.T_route_vehicle;
  const auto truth = true_poses(options.sessions[learned->taken.front()], driven.size());
  if (!truth) return truth.problems();
  // Without truth they are empty, and replace those of an earlier, simulated run.
  std::vector<OutputFile> files = truth_files(truth->empty() ? MapTruth() : MapTruth(driven, *truth));
  files.push_back({"building", "building.json", building_json(learned->building)});
  files.push_back({"sections_svg", kSectionsPicture,
                   svg(SectionPicture{.route = learned->building.routes.front(),
                                      .driven = driven,
                                      .title = fmt::format("{}: sections as learned", taught->route)})});
  auto written = (*directory)->write(files);
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  return outcome;
}

}  // namespace aisle
