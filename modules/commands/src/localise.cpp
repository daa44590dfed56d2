#include "aisle/commands/localise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/commands/known_building.hpp"
#include "aisle/commands/packed_recording.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/learning/walls/relation_error.hpp"
#include "aisle/missions/statistics.hpp"
#include "localisation/log_localisation.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRefuted_m = 0.5;  // a relation this far off refutes a pose
constexpr double kRefuted_rad = 10 * kDegree;
constexpr double kRefutedWithin_m = 5;  // lost so soon after it was found: it never was there

/// Relations between scans at which the vehicle was found, and what they say.
struct RelationCheck {
  std::vector<Pose2> T_map_vehicle;     ///< of all scans; any pose where it was not found
  std::vector<PoseRelation> relations;  ///< with both scans found

  RelationCheck(const LogPoses& poses, const std::vector<PoseRelation>& all) {
    for (const auto& pose : poses.T_map_vehicle) T_map_vehicle.push_back(pose.value_or(Pose2{}));
    std::copy_if(all.begin(), all.end(), std::back_inserter(relations), [&](const PoseRelation& relation) {
      return poses.T_map_vehicle[relation.scan_1] && poses.T_map_vehicle[relation.scan_2];
    });
    const Pose2 T_vehicle_relations =
        relations.empty() ? Pose2{} : frame_of_relations(T_map_vehicle, relations);
    for (Pose2& pose : T_map_vehicle) pose = pose * T_vehicle_relations;
  }

  bool refutes(const FoundSpan& span) const {
    return std::any_of(relations.begin(), relations.end(), [&](const PoseRelation& relation) {
      if (relation.scan_2 < span.first || relation.scan_2 > span.last) return false;
      const Pose2 off =
          between(relation.T_1_2, between(T_map_vehicle[relation.scan_1], T_map_vehicle[relation.scan_2]));
      return off.position().norm() > kRefuted_m || std::abs(off.theta) > kRefuted_rad;
    });
  }
};

Json mean_json(const MeanAndDeviation& m, double unit) {
  return {{"mean", rounded(m.mean / unit, 5)}, {"std", rounded(m.deviation / unit, 5)}};
}

Json places_json(std::span<const PlaceCandidate> places) {
  Json list = Json::array();
  for (const PlaceCandidate& place : places) {
    const Pose2& T = place.T_map_vehicle;
    list.push_back({{"x_m", rounded(T.x, 3)},
                    {"y_m", rounded(T.y, 3)},
                    {"heading_deg", rounded(to_degrees(T.theta), 2)},
                    {"explained_share", rounded(place.fit.explained_share(), 4)},
                    {"misfit_m", rounded(place.fit.misfit_m, 2)}});
  }
  return list;
}

Json figures_of(const LogPoses& poses, const Localiser& localiser, const LaserLog& log,
                const std::vector<PoseRelation>& relations) {
  const RelationCheck check(poses, relations);
  const auto is_refuted = [&](const FoundSpan& span) {
    return (span.ended_lost && span.path_m < kRefutedWithin_m) || check.refutes(span);
  };
  const auto found_scans = std::count_if(poses.T_map_vehicle.begin(), poses.T_map_vehicle.end(),
                                         [](const auto& pose) { return pose.has_value(); });
  Json figures = {
      {"scans", log.scans.size()},
      {"found", !poses.found.empty()},
      {"state", name_of(localiser.state())},
      {"found_share", rounded(static_cast<double>(found_scans) / static_cast<double>(log.scans.size()), 4)},
      {"times_lost", std::count_if(poses.found.begin(), poses.found.end(),
                                   [](const auto& span) { return span.ended_lost; })},
      {"wrong_confident", std::count_if(poses.found.begin(), poses.found.end(), is_refuted)},
      {"time_to_found_s", nullptr},
      {"distance_to_found_m", nullptr},
      {"hint_was_wrong", localiser.hint_was_wrong()}};
  if (!poses.found.empty()) {
    const std::size_t first = poses.found.front().first;
    figures["time_to_found_s"] = rounded(log.scans[first].time_s - log.scans.front().time_s, 2);
    figures["distance_to_found_m"] = rounded(poses.path_m[first], 3);
  }
  if (!localiser.is_found()) figures["places"] = places_json(localiser.places());
  if (!relations.empty()) {
    const RelationError error = relation_error(check.T_map_vehicle, check.relations);
    figures["relations"] = {{"count", relations.size()}, {"found", check.relations.size()}};
    figures["translation_m"] = mean_json(error.translation_m, 1);
    figures["rotation_deg"] = mean_json(error.rotation_rad, kDegree);
  }
  figures["search_ms"] = rounded(1e3 * poses.search_s, 1);
  figures["cycle_ms"] = cycle_figures(poses.cycle_s);
  return figures;
}

std::string place_text(const Json& place) {
  return fmt::format("  {:.2f}, {:.2f} m, {:.0f} degrees: {:.0f} % explained\n", place["x_m"].get<double>(),
                     place["y_m"].get<double>(), place["heading_deg"].get<double>(),
                     100 * place["explained_share"].get<double>());
}

std::string text_of(const Json& figures) {
  std::string text;
  if (figures["found"].get<bool>()) {
    text = fmt::format(
        "found after {:.1f} s and {:.2f} m; known at {:.1f} % of the scans; lost {} times, "
        "sure of a wrong place {} times\n",
        figures["time_to_found_s"].get<double>(), figures["distance_to_found_m"].get<double>(),
        100 * figures["found_share"].get<double>(), figures["times_lost"].get<int>(),
        figures["wrong_confident"].get<int>());
  } else {
    text = fmt::format("not found: {}\n", figures["state"].get<std::string>());
  }
  if (figures.contains("places")) {
    const Json& places = figures["places"];
    if (!places.empty()) text += fmt::format("at the end it may be at {} places:\n", places.size());
    for (const Json& place : places) text += place_text(place);
  }
  if (figures.contains("translation_m")) {
    text += fmt::format(
        "against {} of {} relations: {:.4f} +- {:.4f} m, {:.3f} +- {:.3f} deg\n",
        figures["relations"]["found"].get<int>(), figures["relations"]["count"].get<int>(),
        figures["translation_m"]["mean"].get<double>(), figures["translation_m"]["std"].get<double>(),
        figures["rotation_deg"]["mean"].get<double>(), figures["rotation_deg"]["std"].get<double>());
  }
  return text;
}

std::string tum_of(const LaserLog& log, const LogPoses& poses) {
  std::vector<double> stamps_s;
  std::vector<Pose2> found;
  for (std::size_t i = 0; i < poses.T_map_vehicle.size(); ++i) {
    if (!poses.T_map_vehicle[i]) continue;
    stamps_s.push_back(log.scans[i].stamp_s);
    found.push_back(*poses.T_map_vehicle[i]);
  }
  return tum_text(stamps_s, found);
}

Result<Outcome> localise_recording(const LocaliseOptions& options, Console& console) {
  LocaliserParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (!options.out.empty() && !options.force && std::filesystem::exists(options.out))
    return Problem{{options.out.string()}, "exists already; --force replaces it"};
  const auto building = read_known_building(options.building, console);
  if (!building) return building.problems();
  if (building->walls.walls.empty() && !building->floor)
    return Problem{{options.building.string(), 0, "walls"}, "are missing: nothing can be recognised"};
  const auto settled = read_settled_log(options.log, options.reading, console.progress);
  if (!settled) return settled.problems();
  std::vector<PoseRelation> relations;
  if (options.relations) {
    auto found = read_relations(*options.relations, settled->log);
    if (!found) return found.problems();
    relations = std::move(*found);
  }
  Localiser localiser(params, *building);
  if (options.T_map_hint) localiser.take_hint(*options.T_map_hint);
  const LogPoses poses = LogLocalisation(*settled, localiser).run(console.progress);
  warn_of(settled->warnings, console);

  Outcome outcome{.verb = "localise", .ok = !poses.found.empty()};
  outcome.figures = figures_of(poses, localiser, settled->log, relations);
  outcome.figures["warnings"] = warnings_json(settled->warnings);
  outcome.text = text_of(outcome.figures);
  if (options.out.empty()) return outcome;
  if (Problems problems = write_whole_file(options.out, tum_of(settled->log, poses)); !problems.empty())
    return problems;
  outcome.files["trajectory"] = options.out.string();
  return outcome;
}

}  // namespace

Outcome localise_parameters() {
  LocaliserParams params;
  return parameter_listing("localise", fields_of(params));
}

Result<Outcome> run_localise(const LocaliseOptions& options, Console& console) {
  return with_unpacked(options, &LocaliseOptions::log, console, localise_recording);
}

}  // namespace aisle
