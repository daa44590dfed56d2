#include <fmt/format.h>

#include <utility>

#include "aisle/commands/exploration/judged_exploration.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/report/map_picture.hpp"
#include "exploration/signature_example.hpp"
#include "reproduced.hpp"

namespace aisle {
namespace {

constexpr const char* kExploredWorld = "crossings";
constexpr double kPaperCycleLeast_s = 1.5;  // C99 section 5, on a 133 MHz Pentium
constexpr double kPaperCycleMost_s = 3.5;
constexpr double kC99Speed_mps = 0.3;
constexpr const char* kSignaturePicture = "fig5_signatures.svg";
constexpr const char* kExploringTracePicture = "fig7_trace.svg";
constexpr const char* kGlobalModelPicture = "fig10_global_model.svg";

std::vector<OutputFile> files_of_exploration(const JudgedExploration& explored,
                                             const SignatureExample& example) {
  ExplorationPicture trace = picture_of(explored);
  trace.title = "C99 Fig. 7, simulated: trace of the vehicle";
  const MapPicture model{.walls = explored.building.walls,
                         .title = fmt::format("C99 Fig. 10, simulated: learned global model, {} walls",
                                              explored.building.walls.walls.size()),
                         .has_grid = true};
  const SignaturePicture signatures{
      .learned = example.learned,
      .sensed = example.sensed,
      .title = "C99 Fig. 5, simulated: a view matched with the learned walls",
      .caption = fmt::format(
          "the view is displaced by {:.2f} m, {:.2f} m; correction found: {:.2f} m, {:.2f} m",
          example.displaced_m.x(), example.displaced_m.y(), -example.found_m.x(), -example.found_m.y())};
  return {{"building", "building.json", building_json(explored.building)},
          {"signatures", kSignaturePicture, svg(signatures)},
          {"trace", kExploringTracePicture, svg(trace)},
          {"global_model", kGlobalModelPicture, svg(model)}};
}

}  // namespace

Result<Outcome> reproduce_c99(const ReproduceOptions& options, Console& console) {
  const auto directory = OutputDirectory::open_if_named(
      options.out, options.force,
      {"building.json", kSignaturePicture, kExploringTracePicture, kGlobalModelPicture});
  if (!directory) return directory.problems();
  ExploreOptions explore;
  explore.sensor = ExploringSensor::kMarkers;
  explore.order = ExploringOrder::kPublished;
  explore.seed = options.seed;
  auto setting = read_setting(kExploredWorld, exploring_vehicle(explore), "");
  if (!setting) return setting.problems();
  const auto plan = read_exploration_plan(explore, std::move(*setting));
  if (!plan) return plan.problems();
  auto explored = explore_and_judge(explore, *plan, console);
  if (!explored) return explored.problems();

  Outcome outcome{.verb = "reproduce", .ok = explored->outcome.ok};
  outcome.figures = explored->outcome.figures;
  outcome.figures["sensor"] = "markers";
  outcome.figures["walls"] = explored->building.walls.walls.size();
  outcome.figures["paper"] = {{"cycle_s", {kPaperCycleLeast_s, kPaperCycleMost_s}},
                              {"speed_mps", kC99Speed_mps}};
  const auto& cycle_ms = outcome.figures["cycle_ms"];
  outcome.text =
      explored->outcome.text + fmt::format(
                                   "a cycle, image to command, took {:.1f} ms (median), {:.1f} ms (99th "
                                   "percentile); C99: {} to {} s\n",
                                   cycle_ms["median"].get<double>(), cycle_ms["p99"].get<double>(),
                                   kPaperCycleLeast_s, kPaperCycleMost_s);
  const SignatureExample example = signature_example(explored->scans, explored->T_map_vehicle,
                                                     explored->building.walls, explored->segments);
  outcome.figures["signature_error_m"] = rounded((example.found_m + example.displaced_m).norm(), 4);
  if (!*directory) return outcome;
  auto files = (*directory)->write(files_of_exploration(*explored, example));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  return outcome;
}

}  // namespace aisle
