#include "refining/trip_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/learning/walls/floor_of_log.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/merging/map_alignment.hpp"
#include "aisle/merging/moved_building.hpp"
#include "localisation/log_localisation.hpp"

namespace aisle {
namespace {

constexpr double kLostSoon_m = 5;    // lost so soon after it was found: it never was there
constexpr double kBeforeLost_m = 3;  // on so much path it may have been lost before it noticed

/// The poses that can be relied on.
std::vector<std::optional<Pose2>> reliable_poses(const LogPoses& poses) {
  std::vector<std::optional<Pose2>> reliable(poses.T_map_vehicle.size());
  for (const FoundSpan& span : poses.found) {
    if (span.ended_lost && span.path_m < kLostSoon_m) continue;
    const double until_m =
        span.ended_lost ? poses.path_m[span.last] - kBeforeLost_m : poses.path_m[span.last];
    for (std::size_t i = span.first; i <= span.last && poses.path_m[i] <= until_m; ++i)
      reliable[i] = poses.T_map_vehicle[i];
  }
  return reliable;
}

double path_along(const std::vector<std::optional<Pose2>>& poses) {
  double sum_m = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (poses[i - 1] && poses[i]) sum_m += (poses[i]->position() - poses[i - 1]->position()).norm();
  }
  return sum_m;
}

/// Where the trip's own map lies in the building, by the pose in the middle of those that can be relied on.
Pose2 place_of_map(const MapResult& map, const std::vector<std::optional<Pose2>>& reliable) {
  std::vector<std::size_t> scans;
  for (std::size_t i = 0; i < reliable.size(); ++i) {
    if (reliable[i]) scans.push_back(i);
  }
  const std::size_t scan = scans[scans.size() / 2];
  return *reliable[scan] * map.T_map_vehicle[scan].inverse();
}

/// The map that the trip makes alone, laid onto the building's walls.
Building laid_map(const SettledLog& log, const Building& building,
                  const std::vector<std::optional<Pose2>>& reliable, Progress& progress) {
  const MapResult map = build_map(log.log, {}, log.known, false, progress);
  const Building alone{.name = building.name,
                       .has_dominant_direction = map.has_dominant_direction,
                       .walls = map.walls,
                       .floor = floor_of_log(log.log, map.T_map_vehicle)};
  const MapPlacement laid = settle_map(MapPattern(building), MapPattern(alone), place_of_map(map, reliable));
  return moved_building(alone, laid.T_fixed_moved, building.floor->cell_m());
}

std::string why_not_found(const Localiser& localiser, bool was_found) {
  if (was_found) return "the vehicle was lost wherever it seemed to be found";
  if (localiser.state() == LocaliserState::kNotHere) return "what it saw fits nowhere in the building";
  if (localiser.places().size() > 1)
    return fmt::format("the vehicle may be at {} places that look alike", localiser.places().size());
  return "the vehicle was not found in the building: too little of what it saw is known there";
}

}  // namespace

TripMap trip_map(const SettledLog& log, const Building& building, const LocaliserParams& params,
                 const std::optional<Pose2>& T_map_hint, Progress& progress) {
  Localiser localiser(params, building);
  if (T_map_hint) localiser.take_hint(*T_map_hint);
  const LogPoses poses = LogLocalisation(log, localiser).run(progress);
  const auto reliable = reliable_poses(poses);
  TripMap trip{.building = {.name = building.name}, .scans = log.log.scans.size(), .why_not = {}};
  for (const FoundSpan& span : poses.found) trip.times_lost += span.ended_lost ? 1 : 0;
  trip.found = static_cast<std::size_t>(
      std::count_if(reliable.begin(), reliable.end(), [](const auto& pose) { return pose.has_value(); }));
  trip.path_m = path_along(reliable);
  if (trip.found == 0) {
    trip.why_not = why_not_found(localiser, !poses.found.empty());
    return trip;
  }
  trip.building = laid_map(log, building, reliable, progress);
  return trip;
}

}  // namespace aisle
