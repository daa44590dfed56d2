/// Many trips into one building: `trips TRIPS SEED...`. Each seed is a generated building; a first trip is
/// mapped as `aisle map` does, then one trip after the other is taken in by the steps of `aisle refine`, and
/// the building is written and read in between. All furniture stands elsewhere on each trip, and boxes stand
/// about. Compares the walls with the true ones, in the frame in which the first map lay best: after so many
/// trips, and in the map of that trip alone, laid best by itself. The exit code is 1 if a trip was refused or
/// something drawn was lost.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "aisle/core/process_usage.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/learning/walls/floor_of_log.hpp"
#include "aisle/learning/walls/log_correction.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/merging/building_changes.hpp"
#include "aisle/merging/building_refinement.hpp"
#include "aisle/merging/map_alignment.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/operators/tour_recorder.hpp"
#include "aisle/simulation/paths/free_floor.hpp"
#include "refining/trip_map.hpp"

using namespace aisle;

namespace {

constexpr double kScanHeight_m = 0.3;
constexpr int kBoxes = 10;
constexpr double kOffTour_m = 0.6;    // that furniture stands from the path
constexpr double kNearTour_m = 2.5;   // so near the path boxes stand about
constexpr double kMoved_m = 0.5;      // standard deviation of where furniture stands
constexpr double kStep_m = 0.1;       // along a wall, where it is compared
constexpr double kSameFace_m = 0.15;  // farther from every true face of its direction, a wall is none
constexpr int kPrintEvery = 10;

double path_clearance_m(const World& world, const Furniture& piece) {
  World alone;
  alone.furniture = {piece};
  const auto outline = cross_section(alone, kScanHeight_m);
  return outline.empty() ? 1e9 : clearance_m(world.tour, outline);
}

/// The building on another day.
World on_day(const World& building, std::uint64_t seed) {
  World world = building;
  Random random(seed);
  const FreeFloor floor(obstacles_below(World{.walls = building.walls, .doors = building.doors}, 1.5),
                        building.tour.front(), 0.35);
  const auto put = [&](Furniture& piece, auto propose) {
    for (int i = 0; i < 100; ++i) {
      Furniture moved = piece;
      propose(moved);
      if (!floor.reaches(moved.centre) || path_clearance_m(world, moved) < kOffTour_m) continue;
      piece = moved;
      return true;
    }
    return false;
  };
  for (Furniture& piece : world.furniture) {
    put(piece, [&](Furniture& moved) {
      moved.centre += Vec2(random.normal(kMoved_m), random.normal(kMoved_m));
      moved.heading_rad += random.normal(0.5);
    });
  }
  for (int i = 0; i < kBoxes; ++i) {
    Furniture box{.size = Vec2(random.uniform(0.4, 1.0), random.uniform(0.3, 0.6)), .height_m = 1};
    const bool stands = put(box, [&](Furniture& moved) {
      const Vec2& near = building.tour[random.index(building.tour.size())];
      moved.centre = near + Vec2(random.normal(kNearTour_m), random.normal(kNearTour_m));
      moved.heading_rad = random.uniform(-kPi, kPi);
    });
    if (stands) world.furniture.push_back(box);
  }
  return world;
}

/// The walls alone, as a map would show them.
Building truth_of(const World& building) {
  World bare = building;
  bare.furniture.clear();
  Building truth{.name = "truth", .has_dominant_direction = true};
  for (const Segment2& face : cross_section(bare, kScanHeight_m))
    truth.walls.walls.push_back({.segment = face});
  return truth;
}

struct WallError {
  double mean_m = 0;  ///< of certain walls, across them
  double rms_m = 0;
  double ghost_m = 0;   ///< certain walls where no true face is
  double length_m = 0;  ///< certain walls
  double uncertain_m = 0;
};

WallError error_of(const Building& map, const MapPattern& truth, const Pose2& T_world_map) {
  WallError error;
  double matched_m = 0;
  for (const Wall& wall : map.walls.walls) {
    const Segment2 placed = T_world_map * wall.segment;
    if (!wall.is_certain()) {
      error.uncertain_m += placed.length();
      continue;
    }
    error.length_m += placed.length();
    const Vec2 normal = left_normal((placed.end - placed.start).normalized());
    const int steps = std::max(1, static_cast<int>(std::lround(placed.length() / kStep_m)));
    const double step_m = placed.length() / steps;
    for (int i = 0; i < steps; ++i) {
      const Vec2 p = placed.start + (placed.end - placed.start) * ((i + 0.5) / steps);
      const Surface* const face = truth.facing_wall(p, normal);
      if (face == nullptr || face->segment.distance(p) > kSameFace_m) {
        error.ghost_m += step_m;
        continue;
      }
      const double off_m = std::abs(face->normal.dot(p - face->segment.start));
      error.mean_m += step_m * off_m;
      error.rms_m += step_m * off_m * off_m;
      matched_m += step_m;
    }
  }
  error.mean_m /= matched_m;
  error.rms_m = std::sqrt(error.rms_m / matched_m);
  return error;
}

/// How much of the true faces that the first map has a later one has, too.
double kept_share(const Building& first, const Building& later, const MapPattern& truth,
                  const Pose2& T_world_map) {
  const MapPattern of_first(first), of_later(later);
  const Pose2 T_map_world = T_world_map.inverse();
  const Mat2 turn = rotation(T_map_world.theta);
  double in_first_m = 0, in_both_m = 0;
  for (const WallSample& sample : truth.samples()) {
    const Vec2 p_map = T_map_world * sample.p_map, normal = turn * sample.normal;
    if (of_first.same_wall(p_map, normal) == nullptr) continue;
    in_first_m += sample.length_m;
    in_both_m += of_later.same_wall(p_map, normal) != nullptr ? sample.length_m : 0;
  }
  return in_both_m / in_first_m;
}

template <class Value>
Value value_or_exit(Result<Value> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", to_string(result.problems()));
  std::exit(2);
}

class ManyTrips {
 public:
  explicit ManyTrips(std::uint64_t seed)
      : seed_(seed),
        kind_(kBuildingKinds[seed % std::size(kBuildingKinds)]),
        building_(random_building({.kind = kind_}, Random(seed))),
        truth_(truth_of(building_)),
        truth_pattern_(truth_) {}

  /// @return whether every trip was taken in
  bool run(int trips) {
    learn_first();
    bool is_good = true;
    for (int trip = 1; trip <= trips; ++trip) {
      const bool is_shown = trip % kPrintEvery == 0 || trip == trips;
      is_good &= refine(trip, is_shown);
      if (is_shown) print(trip);
    }
    return is_good;
  }

 private:
  /// @return the true pose at the first scan
  Pose2 record(int trip) {
    SilentProgress progress;
    const std::uint64_t seed = 1000 * seed_ + static_cast<std::uint64_t>(trip);
    TourRecording tour = record_tour(on_day(building_, seed), {}, seed, progress);
    trip_ = {std::move(tour.log), {}, {}};
    const LogFindings findings = value_or_exit(correct_log(trip_.log, {false, {}}, progress));
    trip_.known.guessed_delay_s = findings.odometry_delay_s;
    return tour.T_world_vehicle.front();
  }

  /// The map of the recorded trip alone, and how it lies in the world.
  std::pair<Building, Pose2> single_map(const Pose2& T_world_first) const {
    SilentProgress progress;
    const MapResult result = build_map(trip_.log, {}, trip_.known, false, progress);
    Building building{
        .name = "trip", .has_dominant_direction = result.has_dominant_direction, .walls = result.walls};
    building.floor = floor_of_log(trip_.log, result.T_map_vehicle);
    const Pose2 guess = T_world_first * result.T_map_vehicle.front().inverse();
    return {building, settle_map(truth_pattern_, MapPattern(building), guess).T_fixed_moved};
  }

  void learn_first() {
    std::tie(first_, T_world_map_) = single_map(record(0));
    add_what_a_person_drew(first_);
    now_ = first_;
    fmt::print("{} {}: ", name_of(kind_), seed_);
    print_error(error_of(first_, truth_pattern_, T_world_map_), building_json(first_).size());
  }

  static void add_what_a_person_drew(Building& building) {
    building.places.push_back({kHomePlace, {1, 0.25, 0.5}});
    building.zones.push_back(
        {.kind = Zone::Kind::kKeepOut, .name = "x", .outline = {{3, 0}, {4, 0}, {4, 1}}});
  }

  /// @param maps_it_alone  too, for comparison
  bool refine(int trip, bool maps_it_alone) {
    const Pose2 T_world_first = record(trip);
    if (maps_it_alone) {
      const auto [single, T_world_single] = single_map(T_world_first);
      single_ = error_of(single, truth_pattern_, T_world_single);
    }
    const double before_s = process_cpu_s();
    const std::string why_not = take_in();
    slowest_s_ = std::max(slowest_s_, process_cpu_s() - before_s);
    if (!why_not.empty()) {
      fmt::print("  trip {} refused: {}\n", trip, why_not);
      return false;
    }
    now_ = value_or_exit(parse_building(building_json(now_), "refined"));
    const bool keeps_drawn = now_.places.size() == 1 && now_.zones.size() == 1;
    if (!keeps_drawn) fmt::print("  trip {}: what a person drew is LOST\n", trip);
    return keeps_drawn;
  }

  /// @return why the trip was refused; empty: it was taken in
  std::string take_in() {
    SilentProgress progress;
    const TripMap trip = trip_map(trip_, now_, {}, {}, progress);
    if (!trip.why_not.empty()) return trip.why_not;
    RefinedBuilding refined = refined_building(now_, trip.building, {});
    if (!is_of_building(refined.overlap, {})) return "too few of its walls are the building's";
    changes_ = changes_between(now_, trip.building, {});
    found_share_ = static_cast<double>(trip.found) / static_cast<double>(trip.scans);
    now_ = std::move(refined.building);
    return {};
  }

  void print(int trip) {
    const WallError error = error_of(now_, truth_pattern_, T_world_map_);
    fmt::print("  after {}: ", trip);
    print_error(error, building_json(now_).size());
    fmt::print(
        "    {:.1f} % of the first map's true walls; slowest step {:.2f} s; of this trip found at {:.0f} % "
        "of "
        "the scans, {:.1f} m new, {:.1f} m gone; its own map: {:.2f} cm mean, {:.2f} cm rms, {:.1f} m "
        "ghosts\n",
        100 * kept_share(first_, now_, truth_pattern_, T_world_map_), slowest_s_, 100 * found_share_,
        changes_.length_m(WallChange::kNew), changes_.length_m(WallChange::kGone), 100 * single_.mean_m,
        100 * single_.rms_m, single_.ghost_m);
    std::fflush(stdout);
  }

  void print_error(const WallError& error, std::size_t bytes) {
    fmt::print(
        "walls {:.2f} cm mean, {:.2f} cm rms off; {:.1f} m certain, {:.1f} m of it ghosts, {:.1f} m "
        "uncertain; {} walls, {} bytes ({:.2f} times)\n",
        100 * error.mean_m, 100 * error.rms_m, error.length_m, error.ghost_m, error.uncertain_m,
        now_.walls.walls.size(), bytes,
        static_cast<double>(bytes) / static_cast<double>(building_json(first_).size()));
  }

  std::uint64_t seed_;
  BuildingKind kind_;
  World building_;
  Building truth_;
  MapPattern truth_pattern_;
  SettledLog trip_;
  Building first_, now_;
  BuildingChanges changes_;
  Pose2 T_world_map_;
  WallError single_;
  double found_share_ = 0;
  double slowest_s_ = 0;  ///< processor time of taking in a trip
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "trips TRIPS SEED...\n");
    return 2;
  }
  bool is_good = true;
  for (int i = 2; i < argc; ++i) is_good &= ManyTrips(std::stoull(argv[i])).run(std::atoi(argv[1]));
  return is_good ? 0 : 1;
}
