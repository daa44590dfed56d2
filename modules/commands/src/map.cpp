#include "aisle/commands/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/packed_recording.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/process_usage.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "aisle/learning/walls/floor_of_log.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/learning/walls/map_judgement.hpp"
#include "aisle/learning/walls/published_mapping.hpp"
#include "aisle/learning/walls/relation_error.hpp"
#include "aisle/report/map_picture.hpp"
#include "aisle/report/occupancy.hpp"
#include "settled_log.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kScaleImage = "map-cells.png";  ///< map.png is the picture

Json mean_and_std(const MeanAndDeviation& m, double unit) {
  return {{"mean", rounded(m.mean / unit, 5)}, {"std", rounded(m.deviation / unit, 5)}};
}

Json error_figures(const RelationError& error) {
  return {{"translation_m", mean_and_std(error.translation_m, 1)},
          {"rotation_deg", mean_and_std(error.rotation_rad, kDegree)}};
}

/// The errors of a trajectory at the point of the vehicle that the relations are of.
Json errors_at(const Pose2& T_vehicle_relations, std::vector<Pose2> T_map_vehicle,
               const std::vector<PoseRelation>& relations) {
  for (Pose2& pose : T_map_vehicle) pose = pose * T_vehicle_relations;
  return error_figures(relation_error(T_map_vehicle, relations));
}

Json stage_figures(const std::vector<MapStage>& stages, const std::vector<PoseRelation>& relations,
                   const Pose2& T_vehicle_relations) {
  Json figures = Json::array();
  for (const MapStage& stage : stages) {
    Json row = {{"stage", stage.name}, {"walls", stage.walls}, {"cpu_s", rounded(stage.cpu_s, 2)}};
    if (!relations.empty()) row.update(errors_at(T_vehicle_relations, stage.T_map_vehicle, relations));
    figures.push_back(row);
  }
  return figures;
}

Json figures_of(const RecordingMap& map) {
  const MapResult& result = map.result;
  const std::vector<LaserScan>& scans = map.log.scans;
  const double duration_s = scans.back().time_s - scans.front().time_s;
  Json figures = {{"scans", scans.size()},
                  {"path_m", rounded(result.path_m, 2)},
                  {"walls", result.walls.walls.size()},
                  {"orthogonal_share", rounded(result.walls.orthogonal_share(), 4)},
                  {"no_dominant_direction", !result.has_dominant_direction},
                  {"loop_closures", result.loop_closures.size()},
                  {"odometry_delay_s", rounded(result.odometry_delay_s, 4)},
                  {"cpu_s", rounded(map.cpu_s, 3)},
                  {"realtime_factor", rounded(duration_s / map.cpu_s, 1)},
                  {"peak_rss_mb", rounded(map.peak_rss_mb, 1)}};
  if (map.relations.empty()) return figures;
  const Pose2& T_vehicle_relations = map.T_vehicle_relations;
  figures["relations"] = {{"count", map.relations.size()},
                          {"frame_x_m", rounded(T_vehicle_relations.x, 4)},
                          {"frame_y_m", rounded(T_vehicle_relations.y, 4)}};
  figures.update(errors_at(T_vehicle_relations, result.T_map_vehicle, map.relations));
  if (!result.T_map_vehicle_online.empty())
    figures["online"] = errors_at(T_vehicle_relations, result.T_map_vehicle_online, map.relations);
  return figures;
}

/// How far the map can be trusted, with the reason.
void add_trust(const MapJudgement& judgement, Outcome& outcome) {
  const Trust trust = trust_in(judgement);
  outcome.ok = trust != Trust::kPoor;
  const std::string reason = reason_of(judgement);
  outcome.figures["trust"] = name_of(trust);
  outcome.figures["trust_reason"] = reason;
  outcome.figures["scan_fit_share"] = rounded(judgement.fit_share, 4);
  outcome.figures["scan_pass_share"] = rounded(judgement.pass_share, 4);
  outcome.text += fmt::format("trust: {} ({})\n", name_of(trust), reason);
}

/// The rows above the refined rules in the table of stages: odometry, the published rules, and these with one
/// improvement after the other.
std::vector<MapStage> published_stages(const LaserLog& log, const SegmentParams& segments, double delay_s,
                                       Progress& progress) {
  std::vector<MapStage> stages;
  stages.push_back({"odometry", odometry_poses(log, segments, 0)});
  stages.push_back({"odometry, delay removed", odometry_poses(log, segments, delay_s)});
  const auto add = [&](const char* name, const PublishedParams& params) {
    const double start_s = process_cpu_s();
    const MapResult result = build_published_map(log, segments, params, delay_s, progress);
    stages.push_back({name, result.T_map_vehicle, result.walls.walls.size(), process_cpu_s() - start_s});
  };
  add("published", {});
  add("published, heading by walls", {.heading_from_walls = true});
  add("published, odometry prior", {.heading_from_walls = true, .odometry_prior = true});
  return stages;
}

std::string error_text(const Json& figures) {
  return fmt::format(
      "{:.4f} +- {:.4f} m, {:.3f} +- {:.3f} deg", figures["translation_m"]["mean"].get<double>(),
      figures["translation_m"]["std"].get<double>(), figures["rotation_deg"]["mean"].get<double>(),
      figures["rotation_deg"]["std"].get<double>());
}

std::string mapping_text(const Json& figures) {
  std::string text = fmt::format(
      "{} scans, {:.0f} m of path: {} walls, {:.0f} % of their length on the axes, {} loops closed\n"
      "{:.2f} s of processor time ({:.0f} times faster than the drive), {:.0f} MB of memory\n",
      figures["scans"].get<int>(), figures["path_m"].get<double>(), figures["walls"].get<int>(),
      100 * figures["orthogonal_share"].get<double>(), figures["loop_closures"].get<int>(),
      figures["cpu_s"].get<double>(), figures["realtime_factor"].get<double>(),
      figures["peak_rss_mb"].get<double>());
  if (figures["no_dominant_direction"].get<bool>()) {
    text +=
        "no dominant direction: the walls do not lie on one orthogonal frame; all are kept as oblique "
        "walls\n";
  }
  if (figures.contains("stages")) {
    for (const Json& stage : figures["stages"]) {
      text += fmt::format("  {:<28} {:>6} walls {:>7.2f} s", stage["stage"].get<std::string>(),
                          stage["walls"].get<int>(), stage["cpu_s"].get<double>());
      text += stage.contains("translation_m") ? "  " + error_text(stage) + "\n" : "\n";
    }
  }
  if (figures.contains("relations")) {
    text += fmt::format("against {} relations: {}\n", figures["relations"]["count"].get<int>(),
                        error_text(figures));
  }
  if (figures.contains("online"))
    text += fmt::format("as known while driving: {}\n", error_text(figures["online"]));
  return text;
}

Result<std::map<std::string, std::string>> write_results(const RecordingMap& map, const MapOptions& options,
                                                         const OutputDirectory& out) {
  const MapResult& result = map.result;
  Building building = building_of(map);
  const MapPicture picture{result.walls, result.T_map_vehicle, result.loop_closures, map.name};
  std::vector<double> stamps_s;
  for (const LaserScan& scan : map.log.scans) stamps_s.push_back(scan.stamp_s);
  const OccupancyImage occupancy = occupancy_of(result.walls, *building.floor, map.log, result.T_map_vehicle);
  if (!options.keeps_floor) building.floor.reset();
  const MapMode mode = options.map_mode;
  const bool is_png = mode == MapMode::kScale;
  const std::string image = is_png ? kScaleImage : "map.pgm";
  return out.write({{"building", "building.json", building_json(building)},
                    {"picture_svg", "map.svg", svg(picture)},
                    {"picture_png", "map.png", png(picture)},
                    {"trajectory", "trajectory.tum", tum_text(stamps_s, result.T_map_vehicle)},
                    {is_png ? "map_cells" : "map_pgm", image, map_image_bytes(occupancy, mode)},
                    {"map_yaml", "map.yaml", map_server_yaml(occupancy, image, mode)}});
}

Problems problems_of(const MapOptions& options) {
  constexpr double kOffsetLimit_m = 100;
  constexpr double kDelayLimit_s = 10;
  Problems problems;
  if (const auto& T_vehicle_laser = options.reading.T_vehicle_laser) {
    if (!(T_vehicle_laser->position().norm() <= kOffsetLimit_m)) {
      problems.push_back(
          {{"--laser-offset"}, fmt::format("is farther than {} m from the vehicle", kOffsetLimit_m)});
    }
  }
  if (options.odometry_delay_s && !(std::abs(*options.odometry_delay_s) <= kDelayLimit_s)) {
    problems.push_back(
        {{"--odometry-delay"}, fmt::format("is not from {} to {} s", -kDelayLimit_s, kDelayLimit_s)});
  }
  return problems;
}

std::string name_without_endings(const std::filesystem::path& log) {
  const std::string name = log.filename().string();
  return name.substr(0, name.find('.'));
}

Result<SettledLog> read_log(const MapOptions& options, Console& console) {
  auto settled = options.rules == MapRules::kPublished
                     ? read_unsettled_log(options.log, options.reading)
                     : read_settled_log(options.log, options.reading, console.progress);
  if (settled && options.odometry_delay_s && !settled->known.odometry_delay_s)
    settled->known.odometry_delay_s = options.odometry_delay_s;
  return settled;
}

MapResult build(const MapOptions& options, const MapParams& params, const SettledLog& settled,
                Progress& progress) {
  if (options.rules == MapRules::kRefined)
    return build_map(settled.log, params, settled.known, options.stages, progress);
  return build_published_map(settled.log, params.segments, PublishedParams{},
                             options.odometry_delay_s.value_or(0), progress);
}

/// Where on the vehicle the relations are of a point other than its origin.
void find_point_of_relations(const MapOptions& options, RecordingMap& map) {
  const bool is_given = options.reading.T_vehicle_laser.has_value();
  if (map.relations.empty() || is_given) return;
  const Pose2& T = map.T_vehicle_relations = frame_of_relations(map.result.T_map_vehicle, map.relations);
  if (T.position().norm() == 0) return;
  map.warnings.push_back({{options.relations->string()},
                          fmt::format("the relations are of a point {:.3f} m ahead of and {:.3f} m "
                                      "left of the vehicle's origin by the "
                                      "odometry; the errors are taken there",
                                      T.x, T.y)});
}

Result<RecordingMap> map_unpacked(const MapOptions& options, Console& console) {
  MapParams params;
  FieldList fields = fields_of(params);
  Problems problems = problems_of(options);
  const Problems more = options.parameters.apply_to(fields);
  problems.insert(problems.end(), more.begin(), more.end());
  if (!problems.empty()) return problems;
  auto settled = read_log(options, console);
  if (!settled) return settled.problems();
  RecordingMap map;
  if (options.relations) {
    auto found = read_relations(*options.relations, settled->log);
    if (!found) return found.problems();
    map.relations = std::move(*found);
  }

  map.name = name_without_endings(options.log);
  map.result = build(options, params, *settled, console.progress);
  map.log = std::move(settled->log);
  map.log.laser().T_vehicle_laser = map.result.T_vehicle_laser;
  map.warnings = std::move(settled->warnings);
  for (Problem& warning : at_file(map.result.warnings, options.log.string()))
    map.warnings.push_back(std::move(warning));
  find_point_of_relations(options, map);
  warn_of(map.warnings, console);
  map.cpu_s = process_cpu_s();
  map.peak_rss_mb = process_peak_rss_mb();
  if (options.stages) {
    std::vector<MapStage> stages =
        published_stages(map.log, params.segments, map.result.odometry_delay_s, console.progress);
    map.result.stages.insert(map.result.stages.begin(), stages.begin(), stages.end());
  }
  map.judgement = judge_map(map.result.walls, map.log, map.result.T_map_vehicle);
  return map;
}

}  // namespace

const char* name_of(Trust trust) {
  switch (trust) {
    case Trust::kGood:
      return "good";
    case Trust::kDoubtful:
      return "doubtful";
    case Trust::kPoor:
      return "poor";
    case Trust::kUnknown:
      break;
  }
  return "unknown";
}

std::string reason_of(const MapJudgement& judgement) {
  if (trust_in(judgement) == Trust::kUnknown)
    return fmt::format("{} readings are too few to judge the map by", judgement.readings);
  return fmt::format(
      "{:.0f} % of the readings end on a wall of the map, {:.1f} % would have to pass through one",
      100 * judgement.fit_share, 100 * judgement.pass_share);
}

Building building_of(const RecordingMap& map) {
  Building building{map.name, map.result.has_dominant_direction, map.result.walls};
  building.floor = floor_of_log(map.log, map.result.T_map_vehicle);
  return building;
}

Outcome map_parameters() {
  MapParams params;
  return parameter_listing("map", fields_of(params));
}

Result<RecordingMap> map_recording(const MapOptions& options, Console& console) {
  return with_unpacked(options, &MapOptions::log, console, map_unpacked);
}

Result<Outcome> run_map(const MapOptions& options, Console& console) {
  const auto directory = OutputDirectory::open_if_named(
      options.out, options.force,
      {"building.json", "map.svg", "map.png", "trajectory.tum", "map.pgm", kScaleImage, "map.yaml"});
  if (!directory) return directory.problems();
  const auto map = map_recording(options, console);
  if (!map) return map.problems();

  Outcome outcome{.verb = "map"};
  outcome.figures = figures_of(*map);
  if (options.stages)
    outcome.figures["stages"] = stage_figures(map->result.stages, map->relations, map->T_vehicle_relations);
  outcome.text = mapping_text(outcome.figures);
  add_trust(map->judgement, outcome);
  outcome.figures["warnings"] = warnings_json(map->warnings);
  if (*directory) {
    auto written = write_results(*map, options, **directory);
    if (!written) return written.problems();
    outcome.files = std::move(*written);
    outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  }
  return outcome;
}

}  // namespace aisle
