#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "aisle/missions/statistics.hpp"
#include "aisle/report/picture_sheet.hpp"
#include "aisle/report/section_picture.hpp"
#include "landmarks/landmark_course.hpp"
#include "mission_count.hpp"
#include "reproduced.hpp"
#include "sections/section_course.hpp"

namespace aisle {
namespace {

constexpr double kL03Speed_mps = 0.1;  // L03 section 5; it gives no other figure
constexpr const char* kSectionsFigure = "fig4_sections.svg";
constexpr const char* kTripFigure = "there_and_back.svg";
constexpr const char* kPicturesFigure = "fig7_pictures.png";

nlohmann::ordered_json figures_of(const SectionLearningResult& learned, const JudgedSectionMission& run,
                                  double speed_mps) {
  auto figures = figures_of(run);
  figures["simulated"] = run.mission.is_simulated();
  figures["paper"] = {{"speed_mps", kL03Speed_mps}};
  figures["speed_mps"] = speed_mps;
  figures["length_m"] = rounded(learned.building.routes.front().path.length_m(), 3);
  for (const Section& section : learned.building.routes.front().sections)
    figures["sections"].push_back(section_text(section));
  return figures;
}

std::string text_of(const SectionLearningResult& learned, const JudgedSectionMission& judged,
                    double speed_mps) {
  const SectionMissionResult& run = judged.mission;
  const SectionErrors& errors = *judged.errors;
  const Route& route = learned.building.routes.front();
  std::string text = fmt::format("simulated; learned from one drive: {:.1f} m in {} sections\n",
                                 route.path.length_m(), route.sections.size());
  for (const Section& section : route.sections) text += "  " + section_text(section) + "\n";
  text += fmt::format(
      "there and back   L03                  here\n"
      "speed            about {:.2f} m/s       {:.2f} m/s\n"
      "outcome          navigated, in words  {}{}, {:.1f} m in {:.0f} s, {} collisions\n"
      "home within      no figure            {:.1f} cm, {:.2f} deg\n"
      "distance kept    no figure            {:.1f} cm (rms, right base line)\n"
      "a cycle          no figure            {:.1f} ms (median)\n",
      kL03Speed_mps, speed_mps, run.end.state, run.end.arrived ? "" : ", " + run.end.why, run.distance_m(),
      run.end.duration_s, run.truth->collisions, 100 * errors.closing_m, to_degrees(errors.closing_rad),
      100 * errors.wall_distance_m.rms(), 1000 * quantile(run.cycle_s, 0.5));
  return text;
}

std::vector<OutputFile> files_of(const SectionLearningResult& learned, const SectionMissionResult& run) {
  const Route& route = learned.building.routes.front();
  std::vector<OutputFile> files = {
      {"building", "building.json", building_json(learned.building)},
      {"sections", kSectionsFigure,
       svg(SectionPicture{.route = route,
                          .driven = learned.driven.T_route_vehicle,
                          .title = "L03 Fig. 4, simulated: how each section is driven"})},
      {"trip", kTripFigure,
       svg(SectionPicture{.route = route,
                          .driven = run.T_map_driven,
                          .driven_as = "as driven, there and back",
                          .title = "simulated: there and back along both walls"})}};
  if (!run.images.empty()) files.push_back({"pictures", kPicturesFigure, picture_sheet_png(run.images)});
  return files;
}

}  // namespace

Result<Outcome> reproduce_l03(const ReproduceOptions& options, const SectionTrialParams& params,
                              Console& console) {
  const auto directory = OutputDirectory::open_if_named(
      options.out, options.force, {"building.json", kSectionsFigure, kTripFigure, kPicturesFigure});
  if (!directory) return directory.problems();
  auto setting = read_setting("mini-corridor", "mini", "");
  if (!setting) return setting.problems();
  if (Problems problems = keep_corridor_camera(*setting); !problems.empty()) return problems;
  MissionCount within(console.progress, "runs", 2);
  within.begin(0);
  const auto course = teach_sections(*setting, params.learner, options.seed, 1, within);
  if (!course) return course.problems();
  const SectionLearningResult& learned = course->learned;
  within.begin(1);
  const auto run =
      drive_there_and_back(*setting, params.navigator, *course, 1000 * (options.seed + 1), true, within);
  if (!run) return run.problems();
  Outcome outcome{.verb = "reproduce", .ok = run->mission.end.arrived && run->mission.is_unharmed()};
  outcome.figures = figures_of(learned, *run, params.navigator.speed.speed_mps);
  outcome.text = text_of(learned, *run, params.navigator.speed.speed_mps);
  if (!*directory) return outcome;
  auto files = (*directory)->write(files_of(learned, run->mission));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  return outcome;
}

}  // namespace aisle
