#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "corridor_run.hpp"

namespace aisle {
namespace {

constexpr double kLong_m = 14, kBroad_m = 9;  // of the ring's centre line
constexpr double kHalf_m = 1.1;               // half its corridors' width
constexpr double kRadius_m = 1;
constexpr SightNoise kPoor{.away_m = 0.05, .lateral_m = 0.02, .unseen = 0.7};

/// A corridor around a core, with lines on all its walls.
struct Ring {
  std::vector<CorridorLine> lines;

  explicit Ring(Random& random) {
    for (const double off_m : {-kHalf_m, kHalf_m}) {
      const Vec2 low = Vec2::Constant(-off_m), high = Vec2(kLong_m, kBroad_m) + Vec2::Constant(off_m);
      add_wall(low, {high.x(), low.y()}, random);
      add_wall({high.x(), low.y()}, high, random);
      add_wall(high, {low.x(), high.y()}, random);
      add_wall({low.x(), high.y()}, low, random);
    }
  }

  void add_wall(const Vec2& from, const Vec2& to, Random& random) {
    const double length_m = (to - from).norm();
    for (double at_m = random.uniform(0.3, 1); at_m < length_m; at_m += random.uniform(0.35, 1.2))
      lines.push_back({from + at_m / length_m * (to - from), random.uniform() < 0.5});
  }

  /// The lines that the core does not hide, halfway or anywhere else.
  std::vector<CorridorLine> seen_from(const Vec2& p_map) const {
    std::vector<CorridorLine> seen;
    for (const CorridorLine& line : lines) {
      bool is_hidden = false;
      for (double share = 0.02; share < 0.98; share += 0.02) {
        const Vec2 p = p_map + share * (line.p_map - p_map);
        is_hidden = is_hidden || (p.x() > kHalf_m && p.y() > kHalf_m && p.x() < kLong_m - kHalf_m &&
                                  p.y() < kBroad_m - kHalf_m);
      }
      if (!is_hidden) seen.push_back(line);
    }
    return seen;
  }
};

/// A run more than once around the ring, by odometry with a steering offset; the map begins where the run
/// does.
CorridorRun run_around(const Ring& ring, const SightNoise& noise, Random& random) {
  constexpr double kStep_m = 0.08, kTurnPer_m = 0.3 * kDegree;
  const double straight_m[] = {kLong_m - 2 * kRadius_m, kBroad_m - 2 * kRadius_m, kLong_m - 2 * kRadius_m,
                               kBroad_m - 2 * kRadius_m, kLong_m - 2 * kRadius_m};
  CorridorRun run;
  Pose2 T_ring_vehicle{kRadius_m, 0, 0};
  const auto drive = [&](double path_m, double curvature_per_m) {
    for (double m = 0; m < path_m; m += kStep_m) {
      const double wheelbase_m = corridor_cart().front_steered.wheelbase_m;
      const double steering_rad = std::atan(wheelbase_m * (curvature_per_m + kTurnPer_m));
      LandmarkCycle cycle{.stamp_s = 0.2 * static_cast<double>(run.cycles.size()),
                          .odometry = FrontSteeredMotion{kStep_m / std::cos(steering_rad), steering_rad},
                          .sightings = {},
                          .floor_edges = {}};
      T_ring_vehicle = T_ring_vehicle * end_pose({kStep_m, curvature_per_m * kStep_m});
      cycle.sightings =
          sightings_from(ring.seen_from(T_ring_vehicle.position()), T_ring_vehicle, noise, &random);
      run.cycles.push_back(std::move(cycle));
      run.T_map_vehicle.push_back(T_ring_vehicle);
    }
  };
  for (const double path_m : straight_m) {
    drive(path_m, 0);
    drive(kRadius_m * kPi / 2, 1 / kRadius_m);
  }
  return run;
}

/// Greatest error of the relative pose when the run comes back to a place [m].
double worst_return_m(const std::vector<Pose2>& thought, const std::vector<Pose2>& truth) {
  constexpr std::size_t kLater = 200;
  double worst_m = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t k = i + kLater; k < truth.size(); ++k) {
      if ((truth[k].position() - truth[i].position()).norm() > 0.2) continue;
      const Pose2 off = between(between(truth[i], truth[k]), between(thought[i], thought[k]));
      worst_m = std::max(worst_m, off.position().norm());
    }
  }
  return worst_m;
}

TEST(LandmarkLoops, ARunThatComesBackHasItsStartWhereItWas) {
  for (const std::uint64_t seed : {4U, 5U}) {
    Random random(seed);
    const Ring ring(random);
    const CorridorRun run = run_around(ring, kPoor, random);
    LandmarkLearningParams params;
    EXPECT_LT(
        worst_return_m(learn_landmarks(run.cycles, corridor_cart(), params).T_map_vehicle, run.T_map_vehicle),
        0.05)
        << seed;
    params.adjust = false;
    EXPECT_GT(
        worst_return_m(learn_landmarks(run.cycles, corridor_cart(), params).T_map_vehicle, run.T_map_vehicle),
        0.1)
        << seed << ": the run drifts too little to show anything";
  }
}

TEST(LandmarkLoops, APlacePassedTwiceIsInTheMapOnce) {
  Random random(4);
  const Ring ring(random);
  const CorridorRun run = run_around(ring, {}, random);
  const LearnedRun learned = learn_landmarks(run.cycles, corridor_cart(), {});
  int doubles = 0;
  for (const Landmark& a : learned.map.all()) {
    for (const Landmark& b : learned.map.all()) {
      const double off_m = (a.p_map - b.p_map).norm();
      doubles += &a < &b && a.brighter_right == b.brighter_right && off_m < 0.3 ? 1 : 0;
    }
  }
  EXPECT_LE(doubles, static_cast<int>(learned.map.size()) / 20);
}

}  // namespace
}  // namespace aisle
