/// Maps of parts of a building merged into one, against the map of the whole: `merging SEED...` drives the
/// tour of a generated building each, `merging LOG RELATIONS` takes a recorded log. The run is cut in three
/// that overlap, each third is mapped by itself and turned, and the parts are merged. Then parts of different
/// buildings are tried, which must be refused. One line each; the exit code is 1 if something was merged
/// wrongly.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "aisle/core/process_usage.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "aisle/learning/walls/floor_of_log.hpp"
#include "aisle/learning/walls/log_correction.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/learning/walls/relation_error.hpp"
#include "aisle/merging/building_merging.hpp"
#include "aisle/merging/moved_building.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/operators/tour_recorder.hpp"
#include "aisle/simulation/operators/true_relations.hpp"

using namespace aisle;

namespace {

constexpr std::size_t kParts = 3;
constexpr double kOverlap = 0.1;  // of the whole run, between two parts
constexpr double kWrong_m = 0.5, kWrong_rad = 3 * kDegree;

/// A run with what is known of its true poses.
struct Run {
  std::string name;
  LaserLog log;
  KnownOfLog known;
  std::vector<PoseRelation> relations;
};

/// The map of some of a run's scans, in a frame of its own.
struct PartMap {
  std::size_t first = 0, end = 0;  ///< scans
  MapPart map;
  std::vector<Pose2> T_part_vehicle;
};

LaserLog cut(const LaserLog& log, std::size_t first, std::size_t end) {
  LaserLog part{.lasers = log.lasers};
  const auto at = [](const auto& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  part.scans.assign(at(log.scans, first), at(log.scans, end));
  const std::size_t before = std::max<std::size_t>(part.scans.front().odometry_known, 1) - 1;
  const std::size_t until = std::min(part.scans.back().odometry_known + 2, log.odometry.size());
  part.odometry.assign(at(log.odometry, before), at(log.odometry, until));
  for (LaserScan& scan : part.scans) scan.odometry_known -= std::min(before, scan.odometry_known);
  return part;
}

PartMap map_of(const Run& run, std::size_t first, std::size_t end, const Pose2& T_part_map) {
  SilentProgress progress;
  const LaserLog log = cut(run.log, first, end);
  MapResult result = build_map(log, {}, run.known, false, progress);
  Building building{
      .name = run.name, .has_dominant_direction = result.has_dominant_direction, .walls = result.walls};
  building.floor = floor_of_log(log, result.T_map_vehicle);
  PartMap part{first, end, {fmt::format("{} {}", run.name, first), moved_building(building, T_part_map)}, {}};
  for (const Pose2& T : result.T_map_vehicle) part.T_part_vehicle.push_back(T_part_map * T);
  return part;
}

std::vector<PartMap> parts_of(const Run& run) {
  const double scans = static_cast<double>(run.log.scans.size());
  const Pose2 turned[kParts] = {{}, {3, -7, kPi / 2}, {-20, 4, -kPi}};
  std::vector<PartMap> parts;
  for (std::size_t i = 0; i < kParts; ++i) {
    const double from = std::max(0.0, static_cast<double>(i) / kParts - kOverlap / 2);
    const double to = std::min(1.0, static_cast<double>(i + 1) / kParts + kOverlap / 2);
    parts.push_back(
        map_of(run, static_cast<std::size_t>(from * scans), static_cast<std::size_t>(to * scans), turned[i]));
  }
  return parts;
}

/// The whole run's poses by the merged parts: each scan by the part in whose middle it is.
std::vector<Pose2> merged_poses(const std::vector<PartMap>& parts, const std::vector<Pose2>& T_map_part,
                                std::size_t scans) {
  std::vector<Pose2> T_map_vehicle;
  for (std::size_t scan = 0; scan < scans; ++scan) {
    const std::size_t part = std::min(kParts - 1, scan * kParts / scans);
    T_map_vehicle.push_back(T_map_part[part] * parts[part].T_part_vehicle[scan - parts[part].first]);
  }
  return T_map_vehicle;
}

/// Greatest error of a part's pose against the first part, by the whole run's map.
bool is_wrong(const std::vector<Pose2>& merged, const std::vector<Pose2>& whole) {
  const Pose2 T_whole_merged = whole.front() * merged.front().inverse();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Pose2 off = between(whole[i], T_whole_merged * merged[i]);
    if (off.position().norm() > kWrong_m || std::abs(off.theta) > kWrong_rad) return true;
  }
  return false;
}

std::vector<MapPart> maps_of(const std::vector<PartMap>& parts) {
  std::vector<MapPart> maps;
  for (const PartMap& part : parts) maps.push_back(part.map);
  return maps;
}

/// @return whether it was merged wrongly
bool merge_and_print(const Run& run, const std::vector<PartMap>& parts) {
  SilentProgress progress;
  const MapResult whole = build_map(run.log, {}, run.known, false, progress);
  const double before_s = process_cpu_s();
  const MergedBuilding merged = merge_buildings(maps_of(parts), {}, progress);
  const double cpu_s = process_cpu_s() - before_s;
  const Pose2 T_vehicle_relations = frame_of_relations(whole.T_map_vehicle, run.relations);
  const auto error_of = [&](std::vector<Pose2> poses) {
    for (Pose2& pose : poses) pose = pose * T_vehicle_relations;
    return relation_error(poses, run.relations);
  };
  const RelationError by_whole = error_of(whole.T_map_vehicle);
  fmt::print("{}: whole {:.4f} m {:.3f} deg; ", run.name, by_whole.translation_m.mean,
             to_degrees(by_whole.rotation_rad.mean));
  if (!merged.building) {
    fmt::print("refused, {:.1f} s\n", cpu_s);
    for (const std::string& why : merged.why_refused) fmt::print("  {}\n", why);
    return false;
  }
  const std::vector<Pose2> poses = merged_poses(parts, merged.T_map_part, run.log.scans.size());
  const RelationError by_parts = error_of(poses);
  const bool wrong = is_wrong(poses, whole.T_map_vehicle);
  fmt::print("merged {:.4f} m {:.3f} deg, {:.2f} times; walls {} and {}; {:.1f} s{}\n",
             by_parts.translation_m.mean, to_degrees(by_parts.rotation_rad.mean),
             by_parts.translation_m.mean / by_whole.translation_m.mean, whole.walls.walls.size(),
             merged.building->walls.walls.size(), cpu_s, wrong ? "  WRONG" : "");
  for (const PartLink& link : merged.links)
    fmt::print("  {} and {}: {}\n", link.first, link.second, reason_of(link.alignment));
  return wrong;
}

/// @return whether parts of two buildings were merged
bool mix_and_print(const std::vector<PartMap>& one, const std::vector<PartMap>& other) {
  SilentProgress progress;
  bool wrong = false;
  for (std::size_t i = 0; i < kParts; ++i) {
    const std::vector<MapPart> mixed{one[i].map, other[i].map};
    const MergedBuilding merged = merge_buildings(mixed, {}, progress);
    const MapAlignment& found = merged.links.front().alignment;
    fmt::print("{} with {}: {}: {}\n", mixed[0].name, mixed[1].name, merged.building ? "MERGED" : "refused",
               reason_of(found));
    wrong |= merged.building.has_value();
  }
  return wrong;
}

Run generated(std::uint64_t seed) {
  SilentProgress progress;
  const BuildingKind kind = kBuildingKinds[seed % std::size(kBuildingKinds)];
  const World world = random_building({.kind = kind}, Random(seed));
  TourRecording tour = record_tour(world, {}, seed, progress);
  Random random(seed);
  Run run{fmt::format("{} {}", name_of(kind), seed),
          std::move(tour.log),
          {},
          true_relations(tour.T_world_vehicle, random)};
  return run;
}

template <class Value>
Value value_or_exit(Result<Value> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", to_string(result.problems()));
  std::exit(2);
}

Run recorded(const std::string& file, const std::string& relations) {
  SilentProgress progress;
  auto read = value_or_exit(read_laser_recording(file, {}));
  Run run{file.substr(file.find_last_of('/') + 1), std::move(read.log), {.mounting = read.has_mounting}, {}};
  const LogFindings findings =
      value_or_exit(correct_log(run.log, {!read.has_mounting, read.other_beams}, progress));
  run.known.guessed_delay_s = findings.odometry_delay_s;
  run.relations = value_or_exit(read_relations(relations, run.log));
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<Run> runs;
  const bool is_recorded =
      words.size() == 2 && words.front().find_first_not_of("0123456789") != std::string::npos;
  if (is_recorded) runs.push_back(recorded(words[0], words[1]));
  bool wrong = false;
  std::vector<PartMap> last;
  for (std::size_t i = 0; i < (is_recorded ? 1 : words.size()); ++i) {
    const Run run = is_recorded ? std::move(runs.front()) : generated(std::stoull(words[i]));
    std::vector<PartMap> parts = parts_of(run);
    wrong |= merge_and_print(run, parts);
    if (!last.empty()) wrong |= mix_and_print(last, parts);
    last = std::move(parts);
    std::fflush(stdout);
  }
  return wrong ? 1 : 0;
}
