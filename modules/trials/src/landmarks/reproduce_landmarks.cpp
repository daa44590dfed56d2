#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/landmarks/landmark_truth.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/report/landmark_picture.hpp"
#include "landmarks/landmark_course.hpp"
#include "mission_count.hpp"
#include "reproduced.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRefinements = 5;
constexpr int kPaperInitial = 39;  // C98 section VI: feature points of Fig. 11(a)
constexpr int kPaperRefined = 22;  // and of Fig. 11(b)
constexpr const char* kInitialPicture = "fig11a_landmarks_initial.svg";
constexpr const char* kRefinedPicture = "fig11b_landmarks_refined.svg";
constexpr const char* kTracePicture = "fig12_trace.svg";

/// The landmarks before the first run and after each run, and the result of each run.
struct Experiment {
  Building initial;
  Building refined;
  std::vector<LandmarkTruth> landmarks;  ///< one more than runs
  std::vector<JudgedLandmarkMission> runs;
};

Result<Experiment> run_experiment(const SimulationSetting& setting, const LandmarkCourseParams& params,
                                  std::uint64_t seed, Progress& progress) {
  MissionCount within(progress, "runs", kRefinements + 1);
  within.begin(0);
  const auto taught = teach_run(setting, params, seed, within);
  if (!taught) return taught.problems();
  if (!*taught) return Problem{{setting.world_file.string()}, "the person did not get through"};
  auto learned = learn_route(**taught, "corridor", params.learner);
  if (!learned) return learned.problems();
  const MapTruth truth(learned->T_map_taught, (*taught)->T_world_vehicle);
  const std::vector<VerticalEdge> edges = vertical_edges(setting.world);

  Experiment experiment{
      .initial = learned->building, .refined = learned->building, .landmarks = {}, .runs = {}};
  experiment.landmarks.push_back(compare_with_truth(experiment.initial.landmarks, truth, edges));
  for (std::uint64_t run = 1; run <= kRefinements; ++run) {
    within.begin(run);
    auto driven =
        drive_alone(setting, params, experiment.refined, truth, 1000 * (seed + 1) + run, false, within);
    if (!driven) return driven.problems();
    refine_by(driven->mission, setting.vehicle.description, params.learner.learning, experiment.refined);
    experiment.landmarks.push_back(compare_with_truth(experiment.refined.landmarks, truth, edges));
    experiment.runs.push_back(std::move(*driven));
  }
  return experiment;
}

Json landmark_figures(const LandmarkTruth& found) {
  return {{"landmarks", found.landmarks},
          {"real", found.real},
          {"sure", found.sure},
          {"sure_and_real", found.sure_and_real},
          {"rms_m", rounded(found.rms_m, 4)}};
}

Json figures_of(const Experiment& experiment) {
  Json figures = {{"simulated", true},
                  {"paper", {{"landmarks_initial", kPaperInitial}, {"landmarks_refined", kPaperRefined}}},
                  {"initial", landmark_figures(experiment.landmarks.front())},
                  {"iterations", Json::array()}};
  for (std::size_t i = 0; i < experiment.runs.size(); ++i) {
    Json run = figures_of(experiment.runs[i]);
    run["refined"] = landmark_figures(experiment.landmarks[i + 1]);
    figures["iterations"].push_back(std::move(run));
  }
  return figures;
}

std::string text_of(const Experiment& experiment) {
  std::string text = fmt::format(
      "simulated; C98 had {} landmarks at first and {} after {} runs\n"
      "             driven (rms)                          landmarks then\n"
      "run  across  along  heading  tracking  worst      all  real  sure  sure and real\n",
      kPaperInitial, kPaperRefined, kRefinements);
  const auto landmarks = [](const LandmarkTruth& found) {
    return fmt::format("{:>8}  {:>4}  {:>4}  {:>13}\n", found.landmarks, found.real, found.sure,
                       found.sure_and_real);
  };
  text += fmt::format("{:<48}{}", "taught", landmarks(experiment.landmarks.front()));
  for (std::size_t i = 0; i < experiment.runs.size(); ++i) {
    const MissionErrors& errors = *experiment.runs[i].errors;
    text += fmt::format("{:>4}  {:>4.1f}cm {:>4.1f}cm  {:>4.2f}deg  {:>6.1f}cm {:>4.1f}cm {}", i + 1,
                        100 * errors.across_m.rms(), 100 * errors.along_m.rms(),
                        to_degrees(errors.heading_rad.rms()), 100 * errors.tracking_m.rms(),
                        100 * errors.tracking_m.worst(), landmarks(experiment.landmarks[i + 1]));
  }
  return text;
}

std::string landmarks_picture(const Building& building, const std::string& title) {
  return svg(LandmarkPicture{.landmarks = building.landmarks, .title = title});
}

std::vector<OutputFile> files_of(const Experiment& experiment) {
  const auto title = [](const char* figure, const LandmarkTruth& found) {
    return fmt::format("C98 Fig. {}, simulated: {} landmarks", figure, found.landmarks);
  };
  return {{"building", "building.json", building_json(experiment.refined)},
          {"initial", kInitialPicture,
           landmarks_picture(experiment.initial, title("11(a)", experiment.landmarks.front()))},
          {"refined", kRefinedPicture,
           landmarks_picture(experiment.refined, title("11(b)", experiment.landmarks.back()))},
          {"trace", kTracePicture,
           trace_picture(experiment.refined, experiment.runs.back().mission,
                         "C98 Fig. 12, simulated: planned path and trace")}};
}

}  // namespace

Result<Outcome> reproduce_c98(const ReproduceOptions& options, const LandmarkCourseParams& params,
                              Console& console) {
  const auto directory = OutputDirectory::open_if_named(
      options.out, options.force, {"building.json", kInitialPicture, kRefinedPicture, kTracePicture});
  if (!directory) return directory.problems();
  auto setting = read_setting("c98-corridor", "alv", "");
  if (!setting) return setting.problems();
  if (Problems problems = keep_corridor_camera(*setting); !problems.empty()) return problems;
  const auto experiment = run_experiment(*setting, params, options.seed, console.progress);
  if (!experiment) return experiment.problems();

  Outcome outcome{.verb = "reproduce"};
  outcome.figures = figures_of(*experiment);
  outcome.text = text_of(*experiment);
  for (const JudgedLandmarkMission& run : experiment->runs)
    outcome.ok = outcome.ok && run.mission.end.arrived && run.mission.is_unharmed();
  if (!*directory) return outcome;
  auto files = (*directory)->write(files_of(*experiment));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  return outcome;
}

}  // namespace aisle
