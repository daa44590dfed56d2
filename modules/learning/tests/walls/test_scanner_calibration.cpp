#include "aisle/learning/walls/scanner_calibration.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "pose_matchers.hpp"
#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

Pose2 any_mounting(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)};
}

/// Motions of a vehicle and of a laser that is fixed on it.
std::vector<MotionPair> rigid_motions(const Pose2& T_vehicle_laser, std::size_t count, Random& random,
                                      double turn_max_rad = 0.8, double step_max_m = 0.4) {
  std::vector<MotionPair> pairs(count);
  for (MotionPair& pair : pairs) {
    pair.vehicle = {random.uniform(-step_max_m, step_max_m), 0.1 * random.uniform(-step_max_m, step_max_m),
                    random.uniform(-turn_max_rad, turn_max_rad)};
    pair.laser = T_vehicle_laser.inverse() * pair.vehicle * T_vehicle_laser;
    pair.information = 1e4 * Mat3::Identity();
  }
  return pairs;
}

void make_noisy(std::vector<MotionPair>& pairs, double sigma_m, double sigma_rad, Random& random) {
  for (MotionPair& pair : pairs)
    pair.vehicle =
        pair.vehicle * Pose2{random.normal(sigma_m), random.normal(sigma_m), random.normal(sigma_rad)};
}

/// The motion of a laser as if its scans had been matched without error, ten times a second.
SampledMotion matched_motion(double duration_s) {
  SampledMotion sample;
  for (int i = 0; i <= 10 * duration_s; ++i) {
    sample.times_s.push_back(0.1 * i);
    sample.T_first_laser.push_back(between(on_figure_of_eight(0), on_figure_of_eight(0.1 * i)));
    sample.information.push_back(1e6 * Mat3::Identity());
  }
  return sample;
}

/// The odometry of the same drive, with the headings changed.
std::vector<OdometrySample> counted_turns(double share, double late_s = 0) {
  std::vector<OdometrySample> odometry = RecordedDrive{.walls = {}, .odometry_late_s = late_s}.log().odometry;
  double last_rad = 0, counted_rad = 0;
  for (OdometrySample& sample : odometry) {
    counted_rad += share * wrap_angle(sample.T_odom_vehicle.theta - last_rad);
    last_rad = sample.T_odom_vehicle.theta;
    sample.T_odom_vehicle.theta = wrap_angle(counted_rad);
  }
  return odometry;
}

RC_GTEST_PROP(FindMounting, FindsAnyMountingFromExactMotions, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 truth = any_mounting(random);
  const auto found = find_mounting(rigid_motions(truth, 30, random));
  RC_ASSERT(found.has_value());
  RC_ASSERT((found->T_vehicle_laser.position() - truth.position()).norm() < 1e-6);
  RC_ASSERT(std::abs(wrap_angle(found->T_vehicle_laser.theta - truth.theta)) < 1e-6);
}

RC_GTEST_PROP(FindMounting, KnowsHowFarNoiseLeadsItOff, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 truth = any_mounting(random);
  std::vector<MotionPair> pairs = rigid_motions(truth, 80, random);
  make_noisy(pairs, 0.02, 0.01, random);
  const auto found = find_mounting(pairs);
  RC_ASSERT(found.has_value());
  RC_ASSERT((found->T_vehicle_laser.position() - truth.position()).norm() < 5 * found->sigma_m);
  RC_ASSERT(std::abs(wrap_angle(found->T_vehicle_laser.theta - truth.theta)) < 5 * found->sigma_rad);
  RC_ASSERT(found->sigma_m < 0.05);
}

TEST(FindMounting, IsNotLedAstrayByWheelsThatSlip) {
  Random random(1);
  const Pose2 truth{0.4, -0.1, 1};
  std::vector<MotionPair> pairs = rigid_motions(truth, 60, random);
  for (std::size_t i = 0; i < pairs.size(); i += 10) pairs[i].vehicle = pairs[i].vehicle * Pose2{0.5, 0.2, 0};
  EXPECT_THAT(find_mounting(pairs)->T_vehicle_laser, PoseNear(truth, 0.02, 0.02));
}

TEST(FindMounting, AScaleOfTheWheelsIsNoMounting) {
  Random random(1);
  const Pose2 truth{0.4, -0.1, 1};
  std::vector<MotionPair> pairs = rigid_motions(truth, 60, random);
  for (MotionPair& pair : pairs)
    pair.vehicle = {0.9 * pair.vehicle.x, 0.9 * pair.vehicle.y, pair.vehicle.theta};
  EXPECT_NEAR(wrap_angle(find_mounting(pairs)->T_vehicle_laser.theta - truth.theta), 0, 0.01);
}

TEST(FindMounting, MotionsBackwardsInTimeShowTheSame) {
  Random random(1);
  const Pose2 truth{0.4, -0.1, 1};
  std::vector<MotionPair> pairs = rigid_motions(truth, 30, random);
  for (MotionPair& pair : pairs) {
    pair.laser = pair.laser.inverse();
    pair.vehicle = pair.vehicle.inverse();
  }
  EXPECT_THAT(find_mounting(pairs)->T_vehicle_laser, PoseNear(truth, 1e-6, 1e-6));
}

TEST(FindMounting, NeedsTurnsAndDistanceAndEnoughOfThem) {
  Random random(1);
  const Pose2 truth{0.4, -0.1, 1};
  EXPECT_FALSE(find_mounting(rigid_motions(truth, 60, random, 0)));
  EXPECT_FALSE(find_mounting(rigid_motions(truth, 60, random, 0.8, 0)));
  EXPECT_FALSE(find_mounting(rigid_motions(truth, 19, random)));
  EXPECT_FALSE(find_mounting({}));
}

TEST(FindMounting, AStraightDriveWithNoiseMovesNothing) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<MotionPair> pairs = rigid_motions({0.2, 0, 0}, 60, random, 0);
    make_noisy(pairs, 0.01, 0.005, random);
    const auto found = find_mounting(pairs);
    if (!found) continue;
    EXPECT_THAT(significant(*found, {0.2, 0, 0}), PoseNear(Pose2{0.2, 0, 0}, 0, 0)) << "seed " << seed;
  }
}

TEST(Significant, TakesPositionAndHeadingEachOnlyIfSureOfIt) {
  const Pose2 given{0.1, 0, 0}, found{0.2, 0.1, 5 * kDegree};
  EXPECT_THAT(significant({found, 0.01, 0.5 * kDegree}, given), PoseNear(found, 0, 0));
  EXPECT_THAT(significant({found, 0.05, 0.5 * kDegree}, given), PoseNear(Pose2{0.1, 0, 5 * kDegree}, 0, 0));
  EXPECT_THAT(significant({found, 0.01, 2 * kDegree}, given), PoseNear(Pose2{0.2, 0.1, 0}, 0, 0));
  EXPECT_THAT(significant({found, 0.05, 2 * kDegree}, given), PoseNear(given, 0, 0));
}

TEST(Significant, LeavesTwoCentimetresAndADegreeHoweverSure) {
  EXPECT_THAT(significant({{0.019, 0, 0.9 * kDegree}, 0, 0}, {}), PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(significant({{0.021, 0, 1.1 * kDegree}, 0, 0}, {}),
              PoseNear(Pose2{0.021, 0, 1.1 * kDegree}, 0, 0));
}

TEST(Significant, ComparesHeadingsTheShortWayRound) {
  EXPECT_THAT(significant({{0, 0, -179.7 * kDegree}, 0, 0}, {0, 0, 179.7 * kDegree}),
              PoseNear(Pose2{0, 0, 179.7 * kDegree}, 0, 0));
}

/// Where an estimator says the scanner is after a drive, and how often it found something new.
std::pair<Pose2, int> estimate(const Pose2& truth, const Pose2& given, const Pose2& T_map_odom) {
  MountingEstimator estimator;
  int found = 0;
  for (double time_s = 0; time_s < 40; time_s += 0.1) {
    const Pose2 T_odom_vehicle = on_figure_of_eight(time_s);
    found += estimator.add(T_map_odom * T_odom_vehicle * truth, T_odom_vehicle);
  }
  return {estimator.T_vehicle_laser(given), found};
}

TEST(MountingEstimator, FindsTheMountingInWhateverFramesItIsTracked) {
  const Pose2 truth{0.3, 0.1, 20 * kDegree};
  for (const Pose2& T_map_odom : {Pose2{}, Pose2{-5, 3, 2}})
    EXPECT_THAT(estimate(truth, {}, T_map_odom).first, PoseNear(truth, 1e-3, 1e-3));
}

TEST(MountingEstimator, LeavesAMountingThatIsRight) {
  const Pose2 truth{0.3, 0.1, 20 * kDegree};
  EXPECT_THAT(estimate(truth, truth, {}).first, PoseNear(truth, 0, 0));
}

TEST(MountingEstimator, FindsSomethingEveryTwentyPieces) {
  const double path_m = matched_motion(40).moved_m();
  EXPECT_NEAR(estimate({}, {}, {}).second, path_m / 0.35 / 20, 1);
}

TEST(MountingEstimator, KnowsOnlyWhatIsGivenBeforeItHasSeenEnough) {
  MountingEstimator estimator;
  EXPECT_FALSE(estimator.add({}, {}));
  EXPECT_FALSE(estimator.add({5, 0, 0}, {5, 0, 0}));
  EXPECT_THAT(estimator.T_vehicle_laser({1, 2, 3}), PoseNear(Pose2{1, 2, 3}, 0, 0));
}

TEST(CompareTurns, TurnsThatAreTheSameAgreeAtOnce) {
  const TurnAgreement agreement = compare_turns(matched_motion(40), counted_turns(1), 2);
  EXPECT_NEAR(agreement.correlation, 1, 1e-3);
  EXPECT_NEAR(agreement.slope, 1, 1e-3);
  EXPECT_NEAR(agreement.delay_s, 0, 0.011);
}

TEST(CompareTurns, TellsMirroredReadingsAndWrongAngles) {
  const TurnAgreement mirrored = compare_turns(matched_motion(40), counted_turns(-1), 2);
  EXPECT_NEAR(mirrored.correlation, -1, 1e-3);
  EXPECT_NEAR(mirrored.slope, -1, 1e-3);
  const TurnAgreement wide = compare_turns(matched_motion(40), counted_turns(0.5), 2);
  EXPECT_NEAR(wide.correlation, 1, 1e-3);
  EXPECT_NEAR(wide.slope, 2, 1e-2);
}

TEST(CompareTurns, FindsTheDelayToBothSides) {
  for (const double late_s : {-1.7, -0.33, 0.08, 0.9}) {
    const TurnAgreement agreement = compare_turns(matched_motion(30), counted_turns(1, late_s), 2);
    EXPECT_NEAR(agreement.delay_s, -late_s, 0.011) << "stamps that are late are ahead of the scans'";
    EXPECT_NEAR(agreement.correlation, 1, 1e-2);
  }
}

TEST(CompareTurns, NothingTurnsWhereNothingMoves) {
  EXPECT_EQ(compare_turns(matched_motion(40), counted_turns(0), 2).correlation, 0);
  EXPECT_EQ(compare_turns({}, counted_turns(1), 2).correlation, 0);
}

TEST(MotionPairs, ArePiecesOfBothMotionsWithoutGaps) {
  const std::vector<MotionPair> pairs = motion_pairs(matched_motion(30), counted_turns(1, 0.5), -0.5);
  ASSERT_GT(pairs.size(), 40U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_TRUE(pairs[i].laser.position().norm() >= 0.3 || std::abs(pairs[i].laser.theta) >= 15 * kDegree);
    EXPECT_LT(pairs[i].laser.position().norm(), 0.45);
    EXPECT_THAT(pairs[i].vehicle, PoseNear(pairs[i].laser, 0.005, 0.005));
    EXPECT_EQ(pairs[i].from_s, i > 0 ? pairs[i - 1].to_s : 0);
  }
}

TEST(SampledMotion, CountsDistanceAndTurnsByHandAndNotTheNoise) {
  const SampledMotion square{
      .T_first_laser = {{}, {1, 0, 0}, {1, 0, kPi / 2}, {1, 2, kPi / 2}, {1, 2, -kPi}}};
  EXPECT_NEAR(square.moved_m(), 3, 1e-12);
  EXPECT_NEAR(square.turned_rad(), kPi, 1e-12);
  SampledMotion standing;
  Random random(1);
  for (int i = 0; i < 1000; ++i)
    standing.T_first_laser.push_back(
        {random.normal(0.01), random.normal(0.01), random.normal(0.3 * kDegree)});
  EXPECT_EQ(standing.moved_m(), 0);
  EXPECT_EQ(standing.turned_rad(), 0);
}

TEST(SampleMotion, IsThatOfTheLaserUntilItMovedAndTurnedEnough) {
  const Pose2 T_vehicle_laser{0.3, 0, 1};
  LaserLog log = RecordedDrive{.laser = {-135 * kDegree, 1 * kDegree, 30, T_vehicle_laser}}.log();
  log.lasers.push_back(kOneReadingADegree);
  log.scans.insert(log.scans.begin() + 50, {.time_s = log.scans[50].time_s, .laser = 1});
  const SampledMotion sample = sample_motion(log, std::nullopt);
  EXPECT_GT(sample.median_share, 0.98);
  EXPECT_LT(sample.times_s.size(), 300U);
  EXPECT_GT(sample.turned_rad(), 530 * kDegree);
  const auto on_laser = [&](double time_s) { return on_figure_of_eight(time_s) * T_vehicle_laser; };
  for (std::size_t i = 0; i < sample.times_s.size(); ++i) {
    ASSERT_THAT(sample.T_first_laser[i],
                PoseNear(between(on_laser(0), on_laser(sample.times_s[i])), 0.03, 0.5 * kDegree));
  }
}

}  // namespace
}  // namespace aisle
