#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/pose_filter.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr double kWheelbase_m = 0.75;

/// Odometry without rounding: its errors are Gaussian and as large as it says.
VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = kWheelbase_m;
  vehicle.front_steered_noise = {.distance_scale = 0.01,
                                 .distance_slip_m_per_sqrt_m = 0.005,
                                 .heading_slip_rad_per_sqrt_m = 0.3 * kDegree,
                                 .distance_quantum_m = 0,
                                 .steering_bias_rad = 0.5 * kDegree,
                                 .steering_quantum_rad = 0};
  return vehicle;
}

Mat2 round_covariance(double sigma_m) {
  return square(sigma_m) * Mat2::Identity();
}

std::vector<Vec2> corridor_floor_points() {
  std::vector<Vec2> floor_points;
  for (int i = 0; i < 40; ++i) floor_points.emplace_back(0.45 * i, i % 2 == 0 ? 1.1 : -1.1);
  return floor_points;
}

/// Observations of the points that are 1 to 6 m ahead.
std::vector<SeenPoint> look(const Pose2& T_map_vehicle, double sigma_m, Random* random = nullptr) {
  std::vector<SeenPoint> points;
  for (const Vec2& floor_point : corridor_floor_points()) {
    const Vec2 p_vehicle = T_map_vehicle.inverse() * floor_point;
    if (p_vehicle.x() < 1 || p_vehicle.x() > 6) continue;
    points.push_back({.p_map = floor_point, .p_vehicle = p_vehicle, .covariance = round_covariance(sigma_m)});
    if (random != nullptr) points.back().p_vehicle += Vec2(random->normal(sigma_m), random->normal(sigma_m));
  }
  return points;
}

/// e' P^-1 e: for an honest covariance, 3 on average.
double normalised_error(const PoseFilter& filter, const Pose2& truth) {
  const Vec3 off{filter.pose().x - truth.x, filter.pose().y - truth.y,
                 wrap_angle(filter.pose().theta - truth.theta)};
  return off.dot(filter.covariance().inverse() * off);
}

TEST(PoseFilter, ExactPointsPutTheVehicleWhereTheySay) {
  const Pose2 truth{3.2, -0.15, 0.08};
  PoseFilter filter(cart(), about({3, 0, 0}, 0.3, 5 * kDegree));
  filter.update(look(truth, 0.001), filter.pose());
  EXPECT_THAT(filter.pose(), PoseNear(truth, 1e-4, 1e-4));
}

TEST(PoseFilter, OneExactPointOfTwoCorrectsAlongItsAxesOnly) {
  // Straight ahead of a pose with a known heading: the point measures x and y independently.
  PoseFilter filter(cart(), about({0, 0, 0}, 0.1, 1e-6));
  const SeenPoint ahead{.p_map = {2, 0}, .p_vehicle = {1.9, -0.05}, .covariance = round_covariance(0.1)};
  filter.update(std::vector{ahead}, filter.pose());
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{0.05, 0.025, 0}, 1e-4, 1e-4));  // half way: both are equally sure
  EXPECT_NEAR(filter.covariance()(0, 0), 0.01 / 2, 1e-4);
}

TEST(PoseFilter, LaterObservationsCorrectTheFirstPose) {
  // The start is as unsure as the wheels' scale after 10 m: half of the error is attributed to each.
  VehicleDescription vehicle = cart();
  vehicle.front_steered_noise.distance_slip_m_per_sqrt_m = 0;
  PoseFilter filter(vehicle, about({0, 0, 0}, 0.1, 1e-6), Vec3::Zero());
  for (int i = 0; i < 100; ++i) filter.predict(FrontSteeredMotion{0.1, 0});
  filter.correct(0.2, Vec3::UnitX(), 1e-4);
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{10.2, 0, 0}, 1e-3, 1e-3));
  EXPECT_THAT(filter.first_pose(), PoseNear(Pose2{0.1, 0, 0}, 1e-3, 1e-3));
  for (int i = 0; i < 100; ++i) filter.predict(FrontSteeredMotion{-0.1, 0});
  EXPECT_THAT(filter.pose(), PoseNear(filter.first_pose(), 1e-3, 1e-3));
}

TEST(PoseFilter, NothingSeenChangesNothing) {
  PoseFilter filter(cart(), about({1, 2, 0.3}, 0.1, 0.02));
  const Mat3 before = filter.covariance();
  filter.update({}, {9, 9, 1});
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{1, 2, 0.3}, 0, 0));
  EXPECT_EQ(filter.covariance(), before);
}

TEST(PoseFilter, AVehicleThatStandsStaysAsSureAsItWas) {
  PoseFilter filter(cart(), about({1, 2, 0.3}, 0.1, 0.02));
  const Mat3 before = filter.covariance();
  for (int i = 0; i < 100; ++i) filter.predict(FrontSteeredMotion{0, 0.2});
  EXPECT_EQ(filter.covariance(), before);
}

TEST(PoseFilter, PointsCorrectTheFirstPoseAsScalarsDo) {
  const Vec2 floor_point{12, 0};
  PoseFilter by_point(cart(), about({0, 0, 0}, 0.1, 1e-6)), by_number = by_point;
  for (int i = 0; i < 100; ++i) {
    by_point.predict(FrontSteeredMotion{0.1, 0});
    by_number.predict(FrontSteeredMotion{0.1, 0});
  }
  const SeenPoint ahead{.p_map = floor_point, .p_vehicle = {1.9, 0}, .covariance = round_covariance(0.05)};
  by_point.update(std::vector{ahead}, by_point.pose());
  by_number.correct(0.1, Vec3::UnitX(), 0.05);
  EXPECT_GT(by_point.first_pose().x, 0.02);
  EXPECT_NEAR(by_point.first_pose().x, by_number.first_pose().x, 1e-4);
}

TEST(PoseFilter, APointThatIsWrongMovesThePoseLittle) {
  const Pose2 truth{3, 0, 0};
  std::vector<SeenPoint> points = look(truth, 0.02);
  points[4].p_vehicle += Vec2(0.6, 0);
  PoseFilter filter(cart(), about(truth, 0.3, 5 * kDegree));
  filter.update(points, filter.pose());
  EXPECT_THAT(filter.pose(), PoseNear(truth, 0.01, 0.3 * kDegree));
}

TEST(PoseFilter, DistancesOfCorrectAssociationsAreChiSquared) {
  constexpr int kTrials = 400;
  Random random(7);
  double sum = 0;
  std::size_t degrees = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Pose2 truth{3 + random.normal(0.1), random.normal(0.1), random.normal(1 * kDegree)};
    const PoseFilter filter(cart(), about({3, 0, 0}, 0.1, 1 * kDegree));
    const std::vector<SeenPoint> points = look(truth, 0.03, &random);
    sum += filter.squared_distance(points, filter.pose());
    degrees += 2 * points.size();
  }
  EXPECT_NEAR(sum / static_cast<double>(degrees), 1, 0.05);
}

TEST(PoseFilter, PointsSeenFromAnotherPoseAreFarOff) {
  const PoseFilter filter(cart(), about({3, 0, 0}, 0.01, 0.1 * kDegree));
  const std::vector<SeenPoint> points = look({3.2, -0.1, 0.05}, 0.02);
  EXPECT_GT(filter.squared_distance(points, filter.pose()), 20 * static_cast<double>(points.size()));
}

TEST(PoseFilter, ErrorsAreAsLargeAsTheCovarianceSaysBlindAndSeeing) {
  constexpr int kRuns = 300, kSteps = 40;
  constexpr double kStep_m = 0.1;
  const VehicleDescription vehicle = cart();
  const FrontSteeredNoise& noise = vehicle.front_steered_noise;
  double blind = 0, seeing = 0;
  Random random(5);
  for (int run = 0; run < kRuns; ++run) {
    const UncertainPose2 start = about({0, 0, 0}, 0.05, 1 * kDegree);
    Pose2 truth{random.normal(0.05), random.normal(0.05), random.normal(1 * kDegree)};
    const double distance_scale = 1 + random.normal(noise.distance_scale);
    const double turn_per_m = random.normal(noise.steering_bias_rad / kWheelbase_m);
    PoseFilter filter(vehicle, start);
    for (int i = 0; i < kSteps; ++i) {
      const double path_m =
          kStep_m * distance_scale + random.normal(noise.distance_slip_m_per_sqrt_m * std::sqrt(kStep_m));
      const double turn_rad =
          kStep_m * turn_per_m + random.normal(noise.heading_slip_rad_per_sqrt_m * std::sqrt(kStep_m));
      truth = truth * end_pose({path_m, turn_rad});
      filter.predict(FrontSteeredMotion{kStep_m, 0});
    }
    blind += normalised_error(filter, truth) / kRuns;
    filter.update(look(truth, 0.02, &random), filter.pose());
    seeing += normalised_error(filter, truth) / kRuns;
  }
  EXPECT_THAT(blind, testing::AllOf(testing::Gt(2.4), testing::Lt(3.6)));
  EXPECT_THAT(seeing, testing::AllOf(testing::Gt(2.0), testing::Lt(3.6)));
}

TEST(PoseFilter, SteeringOffItsZeroIsLearnedOnOneStraightAndHelpsOnTheNext) {
  constexpr double kStep_m = 0.1;
  constexpr double kTurn_per_m = 0.5 * kDegree / kWheelbase_m;
  PoseFilter seeing(cart(), about({0, 0, 0}, 0.01, 0.1 * kDegree)), blind = seeing;
  Pose2 truth;
  const auto drive = [&](double path_m, bool looks) {
    for (double s = 0; s < path_m; s += kStep_m) {
      truth = truth * end_pose({kStep_m, kTurn_per_m * kStep_m});
      seeing.predict(FrontSteeredMotion{kStep_m, 0});
      blind.predict(FrontSteeredMotion{kStep_m, 0});
      if (looks) seeing.update(look(truth, 0.02), seeing.pose());
    }
  };
  drive(6, true);
  blind.place(about(truth, 0.01, 0.1 * kDegree));
  drive(5, false);
  EXPECT_THAT(seeing.pose(), PoseNear(truth, 0.06, 0.5 * kDegree));
  EXPECT_GT(std::abs(blind.pose().theta - truth.theta), 2 * kDegree);
}

TEST(PoseFilter, PlacingItElsewhereKeepsTheOdometryErrors) {
  constexpr double kStep_m = 0.1, kScale = 1.02;
  PoseFilter filter(cart(), about({0, 0, 0}, 0.01, 0.1 * kDegree));
  for (int i = 1; i <= 80; ++i) {
    filter.predict(FrontSteeredMotion{kStep_m, 0});
    filter.update(look({kStep_m * kScale * i, 0, 0}, 0.005), filter.pose());
  }
  filter.place(about({0, 50, 0}, 0.01, 0.1 * kDegree));
  for (int i = 0; i < 100; ++i) filter.predict(FrontSteeredMotion{kStep_m, 0});
  EXPECT_NEAR(filter.pose().x, 10.2, 0.03);
}

TEST(PoseFilter, ManyPointsWithOneTiltErrorDoNotMakeItSurerThanTheTilt) {
  constexpr double kPrior_m = 0.3, kTilt_m = 0.03;
  std::vector<SeenPoint> points;
  for (int i = 0; i < 400; ++i) {
    const Vec2 floor_point{2 + 0.01 * i, i % 2 == 0 ? 1.1 : -1.1};
    points.push_back({.p_map = floor_point,
                      .p_vehicle = floor_point,
                      .covariance = round_covariance(0.01),
                      .by_tilt = {kTilt_m, 0}});
  }
  PoseFilter filter(cart(), about({0, 0, 0}, kPrior_m, 1 * kDegree));
  filter.update(points, filter.pose());
  // The sum of distance and tilt error is almost exact; their prior variances divide it.
  const double along_m2 = square(kPrior_m * kTilt_m) / (square(kPrior_m) + square(kTilt_m));
  EXPECT_NEAR(filter.covariance()(0, 0), along_m2, 0.02 * along_m2);
  EXPECT_LT(std::sqrt(filter.covariance()(1, 1)), 0.005);
}

/// The vehicle's true poses and readings on a bend, and what is seen of the points from each.
struct Bend {
  std::vector<OdometryReading> readings;
  std::vector<std::vector<SeenPoint>> seen;
};

Bend drive_bend(int cycles) {
  Random random(5);
  Bend bend;
  Pose2 T_map_vehicle{1, 0, 0};
  for (int i = 0; i < cycles; ++i) {
    const FrontSteeredMotion motion{.distance_m = 0.04, .steering_rad = (i < cycles / 2 ? 6 : -6) * kDegree};
    T_map_vehicle = T_map_vehicle * odometry_step(cart(), motion);
    bend.readings.push_back(
        FrontSteeredMotion{.distance_m = 1.02 * motion.distance_m, .steering_rad = motion.steering_rad});
    bend.seen.push_back(look(T_map_vehicle, 0.05, &random));
  }
  return bend;
}

TEST(PoseFilter, AnImageThatComesLateTellsAsMuchAsInTime) {
  constexpr int kLate = 4;
  const Bend bend = drive_bend(100);
  PoseFilter in_time(cart(), about({1, 0, 0}, 0.1, 2 * kDegree)), late = in_time;
  for (std::size_t i = 0; i < bend.readings.size(); ++i) {
    in_time.predict(bend.readings[i]);
    in_time.update(bend.seen[i], in_time.pose());
    late.predict(bend.readings[i]);
    if (i < kLate) continue;
    ASSERT_TRUE(late.go_back(kLate));
    late.update(bend.seen[i - kLate], late.pose());
    late.catch_up();
  }
  for (std::size_t i = bend.readings.size() - kLate; i < bend.readings.size(); ++i) {
    ASSERT_TRUE(late.go_back(static_cast<int>(bend.readings.size() - 1 - i)));
    late.update(bend.seen[i], late.pose());
    late.catch_up();
  }
  EXPECT_THAT(late.first_pose(), PoseNear(in_time.first_pose(), 1e-3, 1e-3));
  EXPECT_THAT(late.pose(), PoseNear(in_time.pose(), 1e-3, 1e-3));
  EXPECT_TRUE(late.covariance().isApprox(in_time.covariance(), 1e-2));
}

TEST(PoseFilter, DoesNotGoBackBehindWhereItWasPlacedNorBeyondWhatItRemembers) {
  PoseFilter filter(cart(), about({}, 0.1, 1 * kDegree));
  const auto drive = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) filter.predict(FrontSteeredMotion{.distance_m = 0.04});
  };
  drive(3);
  filter.place(about({5, 1, 0}, 0.1, 1 * kDegree));
  EXPECT_FALSE(filter.go_back(1));
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{5, 1, 0}, 0, 0));
  drive(2);
  EXPECT_FALSE(filter.go_back(3));
  ASSERT_TRUE(filter.go_back(2));
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{5, 1, 0}, 1e-12, 1e-12));
  filter.catch_up();
  EXPECT_THAT(filter.pose(), PoseNear(Pose2{5.08, 1, 0}, 1e-12, 1e-12));
  drive(1000);
  EXPECT_FALSE(filter.go_back(100));
  EXPECT_TRUE(filter.go_back(50));
}

}  // namespace
}  // namespace aisle
