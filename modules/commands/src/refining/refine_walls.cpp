#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/packed_recording.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/merging/building_changes.hpp"
#include "aisle/report/building_picture.hpp"
#include "aisle/report/changes_picture.hpp"
#include "merging/changes_figures.hpp"
#include "merging/comparable_map.hpp"
#include "refining/refine_methods.hpp"
#include "refining/trip_map.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

/// What a trip was good for.
struct TakenTrip {
  Problems warnings = {};
  Json figures = Json::object();
  std::string why_refused = {};  ///< empty: it was taken in
  BuildingChanges changes = {};  ///< as the trip saw them
};

Json trip_figures(const std::filesystem::path& recording, const TripMap& trip) {
  const double share = trip.scans > 0 ? static_cast<double>(trip.found) / static_cast<double>(trip.scans) : 0;
  return {{"recording", recording.string()},
          {"scans", trip.scans},
          {"found", trip.found},
          {"found_share", rounded(share, 4)},
          {"path_m", rounded(trip.path_m, 2)},
          {"times_lost", trip.times_lost}};
}

Json refinement_json(const RefinedBuilding& refined) {
  const auto length_m = [&](WallRefinement what) { return rounded(refined.length_m(what), 1); };
  return {{"added", length_m(WallRefinement::kAdded)},
          {"assured", length_m(WallRefinement::kAssured)},
          {"doubted", length_m(WallRefinement::kDoubted)},
          {"removed", length_m(WallRefinement::kRemoved)}};
}

/// Refines the building with a trip, unless it is refused.
TakenTrip take_trip(const TripMap& trip, const RefinementParams& params, Building& building) {
  TakenTrip taken;
  if (!trip.why_not.empty()) {
    taken.why_refused = trip.why_not;
    return taken;
  }
  RefinedBuilding refined = refined_building(building, trip.building, params);
  const MapOverlap& overlap = refined.overlap;
  taken.figures["common_m"] = rounded(overlap.common_m, 1);
  taken.figures["denied_m"] = rounded(overlap.denied_m, 1);
  taken.figures["agreement"] = rounded(overlap.agreement(), 3);
  if (!is_of_building(overlap, params)) {
    taken.why_refused = fmt::format(
        "from where the vehicle was found, {:.1f} m of walls are the building's and {:.1f} m are not",
        overlap.common_m, overlap.denied_m);
    return taken;
  }
  taken.changes = changes_between(building, trip.building, {});
  taken.figures.update(changes_json(taken.changes));
  taken.figures["evidence_m"] = refinement_json(refined);
  taken.figures["corrected_m"] = rounded(refined.moved_rms_m, 4);
  building = std::move(refined.building);
  return taken;
}

/// Reads a recording and takes it in.
Result<TakenTrip> take_recording(const std::filesystem::path& recording, const RefineOptions& options,
                                 const WallRefinerParams& params, Building& building, Console& console) {
  return with_unpacked(
      recording, console,
      [&](const std::filesystem::path& unpacked, Console& unpacked_console) -> Result<TakenTrip> {
        const auto log = read_settled_log(unpacked, options.reading, unpacked_console.progress);
        if (!log) return log.problems();
        const TripMap trip =
            trip_map(*log, building, params.localiser, options.T_map_hint, unpacked_console.progress);
        Json figures = trip_figures(recording, trip);
        TakenTrip taken = take_trip(trip, params.refinement, building);
        figures.update(taken.figures);
        taken.figures = std::move(figures);
        taken.warnings = log->warnings;
        return taken;
      });
}

Json building_figures(const Building& building) {
  double certain_m = 0, uncertain_m = 0;
  for (const Wall& wall : building.walls.walls)
    (wall.is_certain() ? certain_m : uncertain_m) += wall.segment.length();
  return {{"walls", building.walls.walls.size()},
          {"certain_m", rounded(certain_m, 1)},
          {"uncertain_m", rounded(uncertain_m, 1)},
          {"bytes", building_json(building).size()}};
}

std::string trip_text(const Json& trip) {
  std::string text =
      fmt::format("{}: found at {} of {} scans, along {:.0f} m of path; lost {} times\n",
                  trip["recording"].get<std::string>(), trip["found"].get<int>(), trip["scans"].get<int>(),
                  trip["path_m"].get<double>(), trip["times_lost"].get<int>());
  if (!trip.contains("evidence_m")) return text;
  const Json& evidence = trip["evidence_m"];
  text += fmt::format(
      "{:.0f} % of the walls that both could see are in both\n{}"
      "the building: {} m of walls added as uncertain, {} m now certain, {} m doubted, {} m removed; walls "
      "seen "
      "again were corrected by {:.1f} cm\n",
      100 * trip["agreement"].get<double>(), changes_text(trip), evidence["added"].get<double>(),
      evidence["assured"].get<double>(), evidence["doubted"].get<double>(), evidence["removed"].get<double>(),
      100 * trip["corrected_m"].get<double>());
  return text;
}

std::vector<std::string> refined_file_names() {
  return {"building.json", "building.svg", "building.png",  "changes.svg",
          "changes.png",   "trip.tum",     "trip_truth.tum"};
}

std::vector<OutputFile> refined_files(const Building& building, const TakenTrip& last,
                                      const MapTruth& truth) {
  const Json figures = building_figures(building);
  const BuildingPicture whole{
      .building = building,
      .title = building.name,
      .caption = fmt::format("{} walls: {} m certain, {} m uncertain", figures["walls"].get<int>(),
                             figures["certain_m"].get<double>(), figures["uncertain_m"].get<double>())};
  const ChangesPicture changes{last.changes, fmt::format("{}: what the last trip saw changed", building.name),
                               changes_caption(last.figures)};
  std::vector<OutputFile> files = {{"building", "building.json", building_json(building)},
                                   {"picture_svg", "building.svg", svg(whole)},
                                   {"picture_png", "building.png", png(whole)},
                                   {"changes_svg", "changes.svg", svg(changes)},
                                   {"changes_png", "changes.png", png(changes)}};
  if (truth.empty()) return files;
  for (OutputFile& file : truth_files(truth)) files.push_back(std::move(file));
  return files;
}

}  // namespace

Result<Outcome> refine_wall_building(const RefineOptions& options, const WallRefinerParams& params,
                                     Building building, Console& console) {
  if (Problems problems = not_comparable(building, options.building); !problems.empty()) return problems;
  const auto truth = read_map_truth(options.building);
  if (!truth) return truth.problems();
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, refined_file_names());
  if (!directory) return directory.problems();

  Outcome outcome{.verb = "refine"};
  outcome.figures = {{"before", building_figures(building)}, {"trips", Json::array()}};
  Problems warnings;
  TakenTrip last;
  for (const std::filesystem::path& recording : options.trips) {
    auto taken = take_recording(recording, options, params, building, console);
    if (!taken) return taken.problems();
    last = std::move(*taken);
    warn_of(last.warnings, console);
    warnings.insert(warnings.end(), last.warnings.begin(), last.warnings.end());
    outcome.figures["trips"].push_back(last.figures);
    outcome.text += trip_text(last.figures);
    outcome.ok = last.why_refused.empty();
    if (!outcome.ok) break;
  }
  outcome.figures["why_refused"] = last.why_refused;
  outcome.figures["warnings"] = warnings_json(warnings);
  if (!outcome.ok) {
    outcome.text += fmt::format("not refined: {}\n", last.why_refused);
    return outcome;
  }
  outcome.figures["after"] = building_figures(building);
  if (!*directory) return outcome;
  auto written = (*directory)->write(refined_files(building, last, *truth));
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  outcome.text += fmt::format("see {}\n", outcome.files["changes_png"]);
  return outcome;
}

}  // namespace aisle
