#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "corridor_run.hpp"
#include "landmarks/run_walls.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::DoubleNear;
using testing::IsEmpty;

Landmark landmark_of_mass(const Vec2& p_map, double mass) {
  Landmark landmark;
  landmark.p_map = p_map;
  landmark.mass = mass;
  return landmark;
}

LandmarkSighting seen_at(const Vec2& p_vehicle, bool brighter_right = false) {
  return sighting_of(p_vehicle, brighter_right, {});
}

bool is_known(const LandmarkMap& map, const CorridorLine& line, double tolerance_m) {
  return std::any_of(map.all().begin(), map.all().end(), [&](const Landmark& landmark) {
    return landmark.brighter_right == line.brighter_right &&
           (landmark.p_map - line.p_map).norm() < tolerance_m;
  });
}

double position_rmse_m(const std::vector<Pose2>& thought, const std::vector<Pose2>& truth) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum_m2 += (thought[i].position() - truth[i].position()).squaredNorm();
  return std::sqrt(sum_m2 / static_cast<double>(truth.size()));
}

// C98 eq. (16): 1 at the vehicle, a half at the distance sqrt(Cd).
TEST(ConfidenceWeight, FallsWithTheSquareOfTheDistance) {
  EXPECT_DOUBLE_EQ(confidence_weight({0, 0}, 4), 1);
  EXPECT_DOUBLE_EQ(confidence_weight({0, 2}, 4), 0.5);
  EXPECT_DOUBLE_EQ(confidence_weight({6, 0}, 4), 0.1);
}

TEST(UnitedLandmarks, CoverTheDistancesOfBoth) {
  Landmark near, far;
  near.mass = far.mass = 1;
  near.seen_near_m = 1.5, near.seen_far_m = 3;
  far.seen_near_m = 2.5, far.seen_far_m = 6;
  for (const Landmark& both : {united(near, far), united(far, near)}) {
    EXPECT_EQ(both.seen_near_m, 1.5);
    EXPECT_EQ(both.seen_far_m, 6);
  }
}

// Masses 1, 2 and 6 have mean 3: weights 1/3, 2/3, 2; the nearest to the start gets the greatest.
TEST(SettleWeights, WeightsAreMassesOverTheirMeanAndThePrimaryLandmarkGetsTheGreatest) {
  std::vector<Landmark> landmarks = {landmark_of_mass({5, 0}, 1), landmark_of_mass({1, 0}, 2),
                                     landmark_of_mass({9, 0}, 6)};
  settle_weights(landmarks, {0, 0}, 0.15);
  ASSERT_EQ(landmarks.size(), 3U);
  EXPECT_DOUBLE_EQ(landmarks[0].weight, 1.0 / 3);
  EXPECT_DOUBLE_EQ(landmarks[1].weight, 2);
  EXPECT_DOUBLE_EQ(landmarks[2].weight, 2);
}

TEST(SettleWeights, MeanIsOneButForThePrimaryLandmark) {
  Random random(1);
  std::vector<Landmark> landmarks;
  for (int i = 0; i < 50; ++i) landmarks.push_back(landmark_of_mass({1.0 * i, 0}, random.uniform(0.5, 3)));
  landmarks.front().mass = 3;  // the primary one already has the greatest mass
  settle_weights(landmarks, {0, 0}, 0);
  double sum = 0;
  for (const Landmark& landmark : landmarks) sum += landmark.weight;
  EXPECT_NEAR(sum / 50, 1, 1e-12);
}

TEST(SettleWeights, LandmarksBelowTheLeastWeightGo) {
  std::vector<Landmark> landmarks = {landmark_of_mass({0, 0}, 2), landmark_of_mass({1, 0}, 0.1),
                                     landmark_of_mass({2, 0}, 2)};
  settle_weights(landmarks, {0, 0}, 0.15);
  ASSERT_EQ(landmarks.size(), 2U);
  EXPECT_EQ(landmarks[1].p_map.x(), 2);
}

TEST(SettleWeights, WorksWithoutLandmarks) {
  std::vector<Landmark> landmarks;
  settle_weights(landmarks, {0, 0}, 0.15);
  EXPECT_THAT(landmarks, IsEmpty());
}

// C98 eq. (17): seen at 1 m (weight 0.8) and, 10 cm beside it, at 4 m (weight 0.2).
TEST(LandmarkLearner, SightingsCloseTogetherBecomeOneAtTheirWeightedCentroid) {
  LandmarkLearner learner({});
  learner.merge(std::vector{seen_at({1, 0})}, {0, 0, 0});
  const double away_m = 4, mass = 1 / (1 + away_m * away_m / 4);
  EXPECT_THAT(learner.merge(std::vector{seen_at({away_m, 0})}, {1.1 - away_m, 0, 0}),
              testing::ElementsAre(0U));
  ASSERT_EQ(learner.map().size(), 1U);
  EXPECT_NEAR(learner.map()[0].p_map.x(), (0.8 * 1 + mass * 1.1) / (0.8 + mass), 1e-12);
  EXPECT_DOUBLE_EQ(learner.map()[0].mass, 0.8 + mass);
  EXPECT_EQ(learner.map()[0].sightings, 2);
}

TEST(LandmarkLearner, LinesOfOtherPolarityAndLinesFarApartStayApart) {
  LandmarkLearner learner({});
  learner.merge(std::vector{seen_at({1, 0}, false), seen_at({1, 0.05}, true), seen_at({1, 0.5}, false)}, {});
  EXPECT_EQ(learner.map().size(), 3U);
}

TEST(LearnLandmarks, AnExactRunMakesTheExactMap) {
  Random random(1);
  const std::vector<CorridorLine> lines = corridor_lines(8, random);
  CorridorRun run;
  for (int i = 0; i < 60; ++i) {
    const Pose2 truth{0.1 * i, 0, 0};
    run.cycles.push_back({.stamp_s = 0.2 * i,
                          .odometry = FrontSteeredMotion{i == 0 ? 0 : 0.1, 0},
                          .sightings = sightings_from(lines, truth, {})});
    run.T_map_vehicle.push_back(truth);
  }
  const LearnedRun learned = learn_landmarks(run.cycles, corridor_cart(), {});
  EXPECT_LT(position_rmse_m(learned.T_map_vehicle, run.T_map_vehicle), 1e-4);
  for (const CorridorLine& line : lines) {
    if (line.p_map.x() < 1.2) continue;
    EXPECT_TRUE(is_known(learned.map, line, 1e-3)) << line.p_map.transpose();
  }
}

TEST(LearnLandmarks, LearnsTheLinesOfACorridorFromANoisyRun) {
  Random random(2);
  const std::vector<CorridorLine> lines = corridor_lines(14, random);
  const CorridorRun run = corridor_run(lines, 12, {}, random);
  const LearnedRun learned = learn_landmarks(run.cycles, corridor_cart(), {});
  ASSERT_EQ(learned.T_map_vehicle.size(), run.cycles.size());
  EXPECT_THAT(learned.T_map_vehicle.front(), PoseNear(Pose2{}, 1e-3, 1e-3));
  EXPECT_THAT(static_cast<double>(learned.map.size()), DoubleNear(static_cast<double>(lines.size()), 4));
  int known = 0;
  for (const CorridorLine& line : lines) known += is_known(learned.map, line, 0.1) ? 1 : 0;
  EXPECT_GE(known, static_cast<int>(lines.size()) * 9 / 10);
}

TEST(LearnLandmarks, MovingAllPosesAndLandmarksTogetherMakesTheRunBetter) {
  double plain_m = 0, adjusted_m = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const std::vector<CorridorLine> lines = corridor_lines(14, random);
    const CorridorRun run = corridor_run(lines, 12, {}, random);
    LandmarkLearningParams params;
    adjusted_m += position_rmse_m(learn_landmarks(run.cycles, corridor_cart(), params).T_map_vehicle,
                                  run.T_map_vehicle);
    params.adjust = false;
    plain_m += position_rmse_m(learn_landmarks(run.cycles, corridor_cart(), params).T_map_vehicle,
                               run.T_map_vehicle);
  }
  EXPECT_LT(adjusted_m, 0.8 * plain_m);
}

/// Drives 12 m along the bare walls of a corridor that bends by `bend_rad` to the left after 4 m, with wheels
/// that slip by half a degree per metre where no line is seen.
CorridorRun run_along_bare_walls(double bend_rad) {
  constexpr double kStep_m = 0.04, kBend_m = 4, kSlipPer_m = 0.5 * kDegree;
  Random random(3);
  const std::vector<CorridorLine> lines = corridor_lines(5, random);
  CorridorRun run;
  Pose2 T_map_vehicle;
  for (double path_m = 0; path_m < 12; path_m += kStep_m) {
    const double turn_rad = std::abs(path_m - kBend_m) < 0.4 ? bend_rad * kStep_m / 0.8 : 0;
    const double wheelbase_m = corridor_cart().front_steered.wheelbase_m;
    const double slip_per_m = path_m > 5 ? kSlipPer_m : 0;
    const double steering_rad = std::atan(wheelbase_m * (turn_rad / kStep_m + slip_per_m));
    LandmarkCycle cycle{.stamp_s = path_m / 0.4,
                        .odometry = FrontSteeredMotion{kStep_m / std::cos(steering_rad), steering_rad},
                        .sightings = {},
                        .floor_edges = {}};
    if (path_m == 0) {
      cycle.odometry = FrontSteeredMotion{0, 0};
    } else {
      T_map_vehicle = T_map_vehicle * end_pose({kStep_m, turn_rad});
    }
    cycle.sightings = sightings_from(lines, T_map_vehicle, {}, &random);
    const double walls_rad = path_m < kBend_m ? 0 : bend_rad;
    for (const double along_rad : {walls_rad, walls_rad + kPi}) {
      SensedSegment edge;
      edge.heading_rad = wrap_angle(along_rad - T_map_vehicle.theta + random.normal(0.3 * kDegree));
      edge.length_m = 2;
      edge.sigma_heading_rad = 0.3 * kDegree;
      cycle.floor_edges.push_back(edge);
    }
    run.cycles.push_back(std::move(cycle));
    run.T_map_vehicle.push_back(T_map_vehicle);
  }
  return run;
}

double end_error_m(const CorridorRun& run, const LandmarkLearningParams& params) {
  const LearnedRun learned = learn_landmarks(run.cycles, corridor_cart(), params);
  return (learned.T_map_vehicle.back().position() - run.T_map_vehicle.back().position()).norm();
}

LandmarkLearningParams without_walls() {
  LandmarkLearningParams params;
  params.localiser.heading_by_walls = false;
  return params;
}

TEST(LearnLandmarks, WhereNoLineIsSeenTheWallsKeepTheMapStraight) {
  const CorridorRun run = run_along_bare_walls(0);
  EXPECT_LT(end_error_m(run, {}), 0.06);
  EXPECT_GT(end_error_m(run, without_walls()), 0.15);
}

TEST(LearnLandmarks, AnObliqueCorridorIsNotTakenForAStraightOne) {
  const CorridorRun run = run_along_bare_walls(30 * kDegree);
  EXPECT_LT(end_error_m(run, {}), end_error_m(run, without_walls()));
}

/// The first pose is the map's origin, so the corridor has the direction in which it is entered.
TEST(LearnLandmarks, GivesTheDirectionOfTheWallsAllAlong) {
  constexpr double kOblique_rad = 30 * kDegree;
  const CorridorRun run = run_along_bare_walls(kOblique_rad);
  const LearnedRun learned = learn_landmarks(run.cycles, corridor_cart(), {});
  const auto first = walls_around(learned.wall_directions, {0, 0}, 0.1);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->direction_rad, 0, 0.3 * kDegree);
  EXPECT_LT(first->sigma_rad, 0.5 * kDegree);
  const auto last = walls_around(learned.wall_directions, run.T_map_vehicle.back().position(), 2);
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->direction_rad, kOblique_rad, 1.5 * kDegree);
  EXPECT_GT(learned.wall_directions.size(), 4U);
  EXPECT_LT(learned.wall_directions.size(), 10U);
}

TEST(WallDirections, ASegmentWhoseWallsHardlyShowADirectionHasNone) {
  const std::vector<Pose2> T_map_vehicle{{0, 0, 0.1}, {5, 0, 0.1}};
  const std::vector<WallObservation> seen{{0, 0, {0.1, 50 * kDegree}}, {1, 0, {0.1, 1 * kDegree}}};
  const std::vector<WallDirection> directions = wall_directions(seen, T_map_vehicle);
  ASSERT_EQ(directions.size(), 1U);
  EXPECT_EQ(directions[0].p_map.x(), 5);
  EXPECT_NEAR(directions[0].direction_rad, 0, 1e-12);
}

TEST(LearnLandmarks, AnEmptyRunAndABlindOneLearnNothing) {
  EXPECT_TRUE(learn_landmarks({}, corridor_cart(), {}).map.empty());
  std::vector<LandmarkCycle> blind(5);
  const LearnedRun learned = learn_landmarks(blind, corridor_cart(), {});
  EXPECT_TRUE(learned.map.empty());
  EXPECT_EQ(learned.T_map_vehicle.size(), 5U);
}

/// A map learned once, and what has changed in its corridor since.
class RefineLandmarks : public testing::Test {
 protected:
  RefineLandmarks() : random_(7), lines_(corridor_lines(14, random_)) {
    std::erase_if(lines_, [&](const CorridorLine& line) {
      return (line.p_map - gone_.p_map).norm() < 0.4 || (line.p_map - new_.p_map).norm() < 0.4;
    });
    noise_.clutter = 0.6;
    std::vector<CorridorLine> before = lines_;
    before.push_back(gone_);
    const CorridorRun taught = corridor_run(before, 12, noise_, random_);
    LandmarkLearningParams credulous;
    credulous.sightings_min = 1;
    map_ = learn_landmarks(taught.cycles, corridor_cart(), credulous).map;
    now_ = lines_;
    now_.push_back(new_);
  }

  void refine(int runs) {
    for (int i = 0; i < runs; ++i) {
      const CorridorRun run = corridor_run(now_, 12, noise_, random_);
      const RefinedLandmarks refined =
          refine_landmarks(map_, run.cycles, corridor_cart(), about({}, 0.1, 2 * kDegree), {});
      matched_share_ = refined.matched_share;
      map_ = refined.map;
    }
  }

  /// The number of landmarks that are not lines of the corridor.
  int noise() const {
    int count = 0;
    for (const Landmark& landmark : map_.all()) {
      const bool is_real = std::any_of(now_.begin(), now_.end(), [&](const CorridorLine& line) {
        return line.brighter_right == landmark.brighter_right && (line.p_map - landmark.p_map).norm() < 0.15;
      });
      count += is_real ? 0 : 1;
    }
    return count;
  }

  const CorridorLine gone_{{6.1, 1.1}, true}, new_{{8.0, 1.1}, false};
  Random random_;
  SightNoise noise_;
  std::vector<CorridorLine> lines_;  ///< that stay
  std::vector<CorridorLine> now_;
  LandmarkMap map_;
  double matched_share_ = 0;
};

TEST_F(RefineLandmarks, LinesThatStayAreKeptWhileNoiseGoes) {
  const int noise_before = noise();
  refine(4);
  EXPECT_GT(matched_share_, 0.9);
  EXPECT_GE(noise_before, 10);
  EXPECT_LE(noise(), noise_before / 2);
  for (const CorridorLine& line : lines_) {
    if (line.p_map.x() < 1.5) continue;
    EXPECT_TRUE(is_known(map_, line, 0.15)) << line.p_map.transpose();
  }
}

TEST_F(RefineLandmarks, AVanishedLineGoesAndANewOneComes) {
  ASSERT_TRUE(is_known(map_, gone_, 0.15));
  ASSERT_FALSE(is_known(map_, new_, 0.15));
  refine(4);
  EXPECT_FALSE(is_known(map_, gone_, 0.15));
  EXPECT_TRUE(is_known(map_, new_, 0.15));
}

TEST_F(RefineLandmarks, OfARunThroughAnotherBuildingLessThanHalfMatches) {
  now_ = corridor_lines(14, random_);
  refine(1);
  EXPECT_LT(matched_share_, 0.5);
}

TEST_F(RefineLandmarks, CountsTheRunsOnWhichALandmarkWasSeen) {
  refine(2);
  const auto passes = [](const Landmark& a, const Landmark& b) { return a.passes < b.passes; };
  EXPECT_EQ(std::max_element(map_.all().begin(), map_.all().end(), passes)->passes, 3);
}

/// Error of the landmarks against the true lines of a corridor, root mean square.
double map_error_m(const LandmarkMap& map, const std::vector<CorridorLine>& lines) {
  constexpr double kFar_m = 0.3;
  double sum_m2 = 0;
  int known = 0;
  for (const CorridorLine& line : lines) {
    double nearest_m = kFar_m;
    for (const Landmark& landmark : map.all()) {
      if (landmark.brighter_right == line.brighter_right)
        nearest_m = std::min(nearest_m, (landmark.p_map - line.p_map).norm());
    }
    if (nearest_m == kFar_m) continue;
    sum_m2 += nearest_m * nearest_m;
    ++known;
  }
  return std::sqrt(sum_m2 / std::max(known, 1));
}

// Mean of six corridors: 1.02 cm after the first run, 0.91 cm after three more.
TEST(RefineLandmarksTogether, RunsMakeTheMapBetter) {
  double once_m = 0, refined_m = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const std::vector<CorridorLine> lines = corridor_lines(14, random);
    LandmarkMap map = learn_landmarks(corridor_run(lines, 12, {}, random).cycles, corridor_cart(), {}).map;
    once_m += map_error_m(map, lines);
    for (int run = 0; run < 3; ++run)
      map = refine_landmarks(map, corridor_run(lines, 12, {}, random).cycles, corridor_cart(),
                             about({}, 0.1, 2 * kDegree), {})
                .map;
    refined_m += map_error_m(map, lines);
  }
  EXPECT_LT(refined_m, once_m);
}

/// Sigma of a line learned from a run along a corridor.
/// @param wander_per_m  how far the line's floor point moves along the wall with each metre that the vehicle
///                      drives, like an occluding edge in front of a door's leaf
double sigma_of_line_m(double wander_per_m) {
  Random random(4);
  CorridorRun run = corridor_run(corridor_lines(14, random), 12, {}, random);
  const Vec2 p_map_line{7, 1.6};
  for (std::size_t i = 0; i < run.cycles.size(); ++i) {
    const Pose2& T_map_vehicle = run.T_map_vehicle[i];
    const Vec2 p_map = p_map_line + Vec2(wander_per_m * (T_map_vehicle.x - 4), 0);
    const Vec2 p_vehicle = T_map_vehicle.inverse() * p_map;
    if (p_vehicle.x() > kSightMin_m && p_vehicle.x() < kSightMax_m)
      run.cycles[i].sightings.push_back(sighting_of(p_vehicle, true, {}));
  }
  const LandmarkMap map = learn_landmarks(run.cycles, corridor_cart(), {}).map;
  const auto nearest =
      std::min_element(map.all().begin(), map.all().end(), [&](const Landmark& a, const Landmark& b) {
        return (a.p_map - p_map_line).norm() < (b.p_map - p_map_line).norm();
      });
  return std::sqrt(nearest->covariance.trace());
}

TEST(LearnLandmarks, AWanderingLineIsKnownLessSurelyThanAFixedOne) {
  EXPECT_GT(sigma_of_line_m(0.05), 3 * sigma_of_line_m(0));
}

}  // namespace
}  // namespace aisle
