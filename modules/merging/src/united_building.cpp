#include "united_building.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "aisle/core/square.hpp"
#include "aisle/learning/corridors/corridor_tracing.hpp"
#include "aisle/maps/cell_index.hpp"
#include "aisle/matching/wall_estimate.hpp"
#include "aisle/merging/moved_building.hpp"
#include "aisle/vehicle/same_camera.hpp"
#include "same_surface.hpp"

namespace aisle {
namespace {

constexpr double kOnAxis_rad = 0.05 * kDegree;
constexpr double kOneWallGate_m = 0.12;
constexpr double kWallReach_m = 0.5;
constexpr double kWallSigmaLeast_m = 0.005;
constexpr double kWallHeadingSigma_m = 0.02;  // of a wall's ends against each other
constexpr double kOneLandmark_m = 0.08;
constexpr double kOneLandmarkDeviations = 9;  // squared: three standard deviations
constexpr double kOnePlace_m = 0.1;
constexpr double kOnePlace_rad = 5 * kDegree;

SensedSegment as_sensed(const Wall& wall) {
  const double length_m = wall.segment.length();
  return {.segment = wall.segment,
          .centroid = wall.segment.midpoint(),
          .heading_rad = wall.segment.heading(),
          .length_m = length_m,
          .sigma_offset_m = std::max(wall.sigma_m, kWallSigmaLeast_m),
          .sigma_heading_rad = kWallHeadingSigma_m / length_m,
          .start = wall.start,
          .end = wall.end,
          .curved = !wall.is_orthogonal};
}

Wall as_drawn(const WallEstimate& estimate, int sightings, int evidence) {
  return {.segment = estimate.segment(),
          .is_orthogonal = !estimate.is_oblique(),
          .start = estimate.start,
          .end = estimate.end,
          .sightings = sightings,
          .sigma_m = 1 / std::sqrt(estimate.offset_weight),
          .evidence = evidence};
}

/// Walls that several parts have are one.
WallMap united_walls(std::span<const Building> parts) {
  std::vector<WallEstimate> walls;
  std::vector<int> sightings, evidence;
  CellIndex index;
  std::vector<int> near;
  const WallUpdateParams update{.axis_tolerance_rad = kOnAxis_rad, .gate_m = kOneWallGate_m};
  for (const Building& part : parts) {
    for (const Wall& wall : part.walls.walls) {
      if (!(wall.segment.length() > 0)) continue;
      const SensedSegment sensed = as_sensed(wall);
      index.query(wall.segment.start, wall.segment.end, kWallReach_m, near);
      const int at = absorb({sensed, {}}, 0, update, walls, near);
      sightings.resize(walls.size(), 0);
      sightings[static_cast<std::size_t>(at)] += wall.sightings;
      evidence.resize(walls.size(), 0);
      evidence[static_cast<std::size_t>(at)] =
          std::max(evidence[static_cast<std::size_t>(at)], wall.evidence);
      index.add(walls[static_cast<std::size_t>(at)].segment(), at);
    }
  }
  WallMap map;
  for (std::size_t i = 0; i < walls.size(); ++i)
    map.walls.push_back(as_drawn(walls[i], sightings[i], evidence[i]));
  return map;
}

/// Enters what another floor has seen. Where one is free and the other occupied, something stood there at
/// some time, and counts, unless both have that surface and draw it a little apart.
void add_floor(FloorGrid& floor, const FloorGrid& other) {
  const FloorGrid before = floor;
  const FloorBox& known = other.known();
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) {
      const FloorCell cell{x, y};
      const Floor seen = other.at(cell), had = before.at(cell);
      if (seen == Floor::kUnknown || seen == had || had == Floor::kOccupied) continue;
      if (had == Floor::kFree && has_surface_at(before, cell)) continue;
      floor.set(cell, seen);
    }
  }
}

bool is_one_landmark(const Landmark& a, const Landmark& b) {
  const Vec2 off = a.p_map - b.p_map;
  if (a.brighter_right != b.brighter_right || off.norm() > kOneLandmark_m) return false;
  const Mat2 covariance = a.covariance + b.covariance + square(0.01) * Mat2::Identity();
  return off.dot(covariance.inverse() * off) < kOneLandmarkDeviations;
}

/// Both sightings of one landmark together.
Landmark fused(const Landmark& a, const Landmark& b) {
  Landmark both = a.mass >= b.mass ? a : b;
  const double mass = a.mass + b.mass, share = mass > 0 ? b.mass / mass : 0.5;
  both.p_map = (1 - share) * a.p_map + share * b.p_map;
  both.mass = mass;
  both.weight = std::max(a.weight, b.weight);
  both.sightings = a.sightings + b.sightings;
  both.passes = a.passes + b.passes;
  both.seen_near_m = std::min(a.seen_near_m, b.seen_near_m);
  both.seen_far_m = std::max(a.seen_far_m, b.seen_far_m);
  return both;
}

void add_landmarks(LandmarkMap& landmarks, const LandmarkMap& others) {
  std::vector<int> near;
  for (const Landmark& landmark : others.all()) {
    if (landmark.weight <= 0) continue;
    landmarks.within(landmark.p_map, kOneLandmark_m, near);
    const auto same = std::find_if(near.begin(), near.end(), [&](int i) {
      return is_one_landmark(landmarks[static_cast<std::size_t>(i)], landmark);
    });
    if (same == near.end()) {
      landmarks.add(landmark);
    } else {
      const auto index = static_cast<std::size_t>(*same);
      landmarks.replace(index, fused(landmarks[index], landmark));
    }
  }
}

template <class Named>
bool has_name(const std::vector<Named>& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

/// A name that nothing has yet: the given one, else with the part's behind it, else numbered.
template <class Named>
std::string free_name(const std::vector<Named>& taken, const std::string& name, const std::string& part) {
  if (!has_name(taken, name)) return name;
  std::string other = fmt::format("{} ({})", name, part);
  for (int i = 2; has_name(taken, other); ++i) other = fmt::format("{} ({} {})", name, part, i);
  return other;
}

bool is_one_place(const MapPlace& a, const MapPlace& b) {
  const Pose2 off = between(a.T_map_place, b.T_map_place);
  return a.name == b.name && a.has_heading == b.has_heading && off.position().norm() < kOnePlace_m &&
         std::abs(off.theta) < kOnePlace_rad;
}

class Union {
 public:
  Union(Building first, std::vector<std::string>& notes) : whole_(std::move(first)), notes_(notes) {}

  void add(const std::string& name, Building part) {
    add_floor(*whole_.floor, *part.floor);
    add_names(name, part);
    whole_.barriers.insert(whole_.barriers.end(), part.barriers.begin(), part.barriers.end());
    whole_.zones.insert(whole_.zones.end(), part.zones.begin(), part.zones.end());
    add_what_a_camera_saw(name, part);
  }

  Building take(WallMap walls) {
    whole_.walls = std::move(walls);
    whole_.corridors = trace_corridors(*whole_.floor, home_of(whole_).position(), {});
    return std::move(whole_);
  }

 private:
  void add_names(const std::string& part_name, const Building& part) {
    for (MapPlace place : part.places) {
      if (std::any_of(whole_.places.begin(), whole_.places.end(),
                      [&](const MapPlace& known) { return is_one_place(known, place); }))
        continue;
      const std::string name = free_name(whole_.places, place.name, part_name);
      if (name != place.name)
        notes_.push_back(fmt::format("place '{}' of {} is now '{}'", place.name, part_name, name));
      place.name = name;
      whole_.places.push_back(place);
    }
    for (Route route : part.routes) {
      const std::string name = free_name(whole_.routes, route.name, part_name);
      if (name != route.name)
        notes_.push_back(fmt::format("route '{}' of {} is now '{}'", route.name, part_name, name));
      route.name = name;
      whole_.routes.push_back(std::move(route));
    }
  }

  void add_what_a_camera_saw(const std::string& part_name, const Building& part) {
    if (part.landmarks.empty()) return;
    if (!whole_.camera) {
      whole_.camera = part.camera;
    } else if (part.camera && !check_same_camera(*whole_.camera, *part.camera).empty()) {
      notes_.push_back(fmt::format("{} landmarks of {} are left out: another camera saw them",
                                   part.landmarks.size(), part_name));
      return;
    }
    add_landmarks(whole_.landmarks, part.landmarks);
    whole_.wall_directions.insert(whole_.wall_directions.end(), part.wall_directions.begin(),
                                  part.wall_directions.end());
  }

  Building whole_;
  std::vector<std::string>& notes_;
};

/// The narrowest of the parts' floor cells; nullopt: no part has a floor.
std::optional<double> finest_cell_m(std::span<const MapPart> parts) {
  std::optional<double> finest_m;
  for (const MapPart& part : parts) {
    if (!part.building.floor) continue;
    const double cell_m = part.building.floor->cell_m();
    finest_m = std::min(finest_m.value_or(cell_m), cell_m);
  }
  return finest_m;
}

}  // namespace

Building united_building(std::span<const MapPart> parts, std::span<const Pose2> T_map_part,
                         std::vector<std::string>& notes) {
  const std::optional<double> cell_m = finest_cell_m(parts);
  std::vector<Building> placed;
  placed.reserve(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    placed.push_back(moved_building(parts[i].building, T_map_part[i], cell_m));
  WallMap walls = united_walls(placed);
  Union whole(std::move(placed.front()), notes);
  for (std::size_t i = 1; i < parts.size(); ++i) whole.add(parts[i].name, std::move(placed[i]));
  return whole.take(std::move(walls));
}

}  // namespace aisle
