#include "aisle/commands/explore.hpp"

#include <optional>
#include <utility>

#include "aisle/commands/exploration/judged_exploration.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "exploration/exploration_report.hpp"

namespace aisle {
namespace {

/// The learned building, pictures of it, and the report.
std::vector<OutputFile> files_of(const JudgedExploration& explored) {
  const ExplorationPicture picture = picture_of(explored);
  return {{"building", "building.json", building_json(explored.building)},
          {"picture_png", "exploration.png", png(picture)},
          {"picture_svg", "exploration.svg", svg(picture)},
          {"report", "report.html", exploration_report(picture, explored.building, explored.outcome)}};
}

Result<std::optional<OutputDirectory>> open_results(const ExploreOptions& options) {
  return OutputDirectory::open_if_named(
      options.out, options.force, {"building.json", "exploration.png", "exploration.svg", "report.html"});
}

/// Writes the results, if they are to be written.
Result<Outcome> kept(Result<JudgedExploration> explored, const std::optional<OutputDirectory>& directory) {
  if (!explored) return explored.problems();
  Outcome& outcome = explored->outcome;
  if (directory) {
    auto written = directory->write(files_of(*explored));
    if (!written) return written.problems();
    outcome.files = std::move(*written);
    outcome.text += "see " + outcome.files.at("report") + "\n";
  }
  return std::move(outcome);
}

}  // namespace

Outcome explore_parameters() {
  ExplorerNavigatorParams params;
  return parameter_listing("explore", fields_of(params));
}

Result<Outcome> run_explore(const ExploreOptions& options, Console& console) {
  if (!options.connection.empty()) {
    const auto directory = open_results(options);
    if (!directory) return directory.problems();
    return kept(explore_with_robot(options, console), *directory);
  }
  auto setting =
      read_setting(options.world, exploring_vehicle(options), options.scenario, options.plan_pixel_m);
  if (!setting) return setting.problems();
  for (const std::string& warning : setting->warnings) console.warn(warning);
  const auto plan = read_exploration_plan(options, std::move(*setting));
  if (!plan) return plan.problems();
  const auto directory = open_results(options);
  if (!directory) return directory.problems();
  return kept(explore_and_judge(options, *plan, console), *directory);
}

}  // namespace aisle
