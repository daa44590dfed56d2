#include "landmarks/landmark_adjustment.hpp"

#include <ceres/jet.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "aisle/core/random.hpp"
#include "corridor_run.hpp"
#include "landmarks/landmark_residuals.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr double kAdjustedStep_m = 0.08;

struct RunNoise {
  double away_m = 0, lateral_m = 0;      ///< of each sighting, at 1 m
  double tilt = 0;                       ///< of each image, in standard deviations
  double scale = 0, turn_per_m = 0;      ///< of the odometry, all along
  double slip_m = 0, turn_slip_rad = 0;  ///< of each motion
};

constexpr RunNoise kUsualRun{.away_m = 0.015,
                             .lateral_m = 0.004,
                             .tilt = 1,
                             .scale = 0.01,
                             .turn_per_m = 0.3 * kDegree,
                             .slip_m = 0.001,
                             .turn_slip_rad = 0.05 * kDegree};

/// Where the vehicle is when it has driven the motions that its odometry counts.
std::vector<Pose2> counted_poses(const std::vector<LandmarkCycle>& cycles, const Pose2& T_map_start) {
  std::vector<Pose2> poses;
  for (const LandmarkCycle& cycle : cycles) {
    const Arc arc = arc_of(corridor_cart().front_steered, std::get<FrontSteeredMotion>(cycle.odometry));
    poses.push_back((poses.empty() ? T_map_start : poses.back()) * end_pose(arc));
  }
  return poses;
}

/// A run along a corridor of which it is known which sighting shows which line.
struct MatchedRun {
  std::vector<LandmarkCycle> cycles;
  std::vector<LandmarkObservation> observations;
  std::vector<LandmarkLoop> loops;
  std::vector<WallObservation> walls;
  std::vector<Landmark> known;
  std::vector<Pose2> truth;
  std::vector<Landmark> true_landmarks;

  RunEvidence evidence() const { return {cycles, observations, loops, walls, known}; }

  std::vector<Pose2> counted() const { return counted_poses(cycles, truth.front()); }

  /// Each landmark where its first sighting shows it.
  std::vector<Landmark> first_seen(const std::vector<Pose2>& T_map_vehicle) const {
    std::vector<Landmark> landmarks = true_landmarks;
    for (auto seen = observations.rbegin(); seen != observations.rend(); ++seen)
      landmarks[seen->landmark].p_map =
          T_map_vehicle[seen->cycle] * cycles[seen->cycle].sightings[seen->sighting].p_vehicle;
    return landmarks;
  }

  /// The vehicle moves on by what it counts, and a little more.
  void move(const FrontSteeredMotion& motion, const RunNoise& noise, Random& random) {
    LandmarkCycle cycle;
    cycle.odometry = motion;
    Arc arc = arc_of(corridor_cart().front_steered, motion);
    arc.turn_rad += arc.length_m * noise.turn_per_m + random.normal(noise.turn_slip_rad);
    arc.length_m = arc.length_m * (1 + noise.scale) + random.normal(noise.slip_m);
    truth.push_back(truth.empty() ? Pose2{} : truth.back() * end_pose(arc));
    cycles.push_back(cycle);
  }

  /// All landmarks in sight.
  void look(const RunNoise& noise, Random& random) {
    const double tilt = random.normal(noise.tilt);
    for (std::size_t i = 0; i < true_landmarks.size(); ++i) {
      const Vec2 p_vehicle = truth.back().inverse() * true_landmarks[i].p_map;
      if (p_vehicle.x() < kSightMin_m || p_vehicle.x() > kSightMax_m) continue;
      LandmarkSighting sighting = sighting_of(p_vehicle, false, {});
      const double distance_m = p_vehicle.norm();
      const Vec2 away = p_vehicle / distance_m;
      sighting.p_vehicle += random.normal(noise.away_m * square(distance_m / 2)) * away +
                            random.normal(noise.lateral_m * distance_m) * left_normal(away) +
                            tilt * sighting.by_tilt;
      observations.push_back({cycles.size() - 1, cycles.back().sightings.size(), i});
      cycles.back().sightings.push_back(sighting);
    }
  }
};

/// Straight ahead, as the odometry counts it.
MatchedRun run_ahead(double path_m, const RunNoise& noise = {}, Random random = Random(1)) {
  MatchedRun run;
  for (const CorridorLine& line : corridor_lines(path_m + kSightMax_m, random)) {
    Landmark landmark;
    landmark.p_map = line.p_map;
    run.true_landmarks.push_back(landmark);
  }
  for (double at_m = 0; at_m <= path_m; at_m += kAdjustedStep_m) {
    run.move({run.cycles.empty() ? 0 : kAdjustedStep_m, 0}, noise, random);
    run.look(noise, random);
  }
  return run;
}

struct Adjusted {
  std::vector<Pose2> T_map_vehicle;
  std::vector<Landmark> landmarks;
  std::vector<Mat2> spread;
};

Adjusted adjusted(const MatchedRun& run, std::vector<Pose2> T_map_vehicle, std::vector<Landmark> landmarks) {
  std::vector<Mat2> spread = adjust_landmarks(run.evidence(), corridor_cart(), T_map_vehicle, landmarks);
  return {std::move(T_map_vehicle), std::move(landmarks), std::move(spread)};
}

double run_rmse_m(const std::vector<Pose2>& thought, const std::vector<Pose2>& truth) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum_m2 += (thought[i].position() - truth[i].position()).squaredNorm();
  return std::sqrt(sum_m2 / static_cast<double>(truth.size()));
}

double landmarks_rmse_m(const std::vector<Landmark>& thought, const std::vector<Landmark>& truth) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) sum_m2 += (thought[i].p_map - truth[i].p_map).squaredNorm();
  return std::sqrt(sum_m2 / static_cast<double>(truth.size()));
}

void move_along(const Pose2& T_moved_map, std::vector<Landmark>& landmarks) {
  const Mat2 R = rotation(T_moved_map.theta);
  for (Landmark& landmark : landmarks) {
    landmark.p_map = T_moved_map * landmark.p_map;
    landmark.covariance = R * landmark.covariance * R.transpose();
  }
}

template <std::size_t... kSizes>
constexpr std::size_t sum_of = (kSizes + ... + 0);

/// The residual at these unknowns, all blocks one after the other.
template <std::size_t kResiduals, std::size_t... kSizes, class Error, class T>
std::array<T, kResiduals> residual_of(const Error& error, const std::array<T, sum_of<kSizes...>>& unknowns) {
  std::array<T, kResiduals> residual;
  const T* next = unknowns.data();
  const auto block = [&next](std::size_t size) {
    const T* begin = next;
    next += size;
    return begin;
  };
  const std::array<const T*, sizeof...(kSizes)> blocks{block(kSizes)...};
  std::apply([&](auto... block_of) { error(block_of..., residual.data()); }, blocks);
  return residual;
}

/// Compares the derivatives that the solver gets with central differences.
template <std::size_t kResiduals, std::size_t... kSizes, class Error>
void expect_true_derivatives(const Error& error, const std::array<double, sum_of<kSizes...>>& unknowns) {
  constexpr std::size_t kUnknowns = sum_of<kSizes...>;
  constexpr double kProbe_sigmas = 1e-5;
  using Jet = ceres::Jet<double, static_cast<int>(kUnknowns)>;
  std::array<Jet, kUnknowns> jets;
  for (std::size_t u = 0; u < kUnknowns; ++u) jets[u] = Jet(unknowns[u], static_cast<int>(u));
  const auto analytic = residual_of<kResiduals, kSizes...>(error, jets);
  for (std::size_t u = 0; u < kUnknowns; ++u) {
    auto less = unknowns, more = unknowns;
    less[u] -= kProbe_sigmas;
    more[u] += kProbe_sigmas;
    const auto low = residual_of<kResiduals, kSizes...>(error, less);
    const auto high = residual_of<kResiduals, kSizes...>(error, more);
    for (std::size_t i = 0; i < kResiduals; ++i) {
      const double slope = (high[i] - low[i]) / (2 * kProbe_sigmas);
      EXPECT_NEAR(analytic[i].v(static_cast<Eigen::Index>(u)), slope, 1e-6 * std::max(1.0, std::abs(slope)))
          << "residual " << i << " by unknown " << u;
    }
  }
}

Pose2 any_place(Random& random) {
  return {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-kPi, kPi)};
}

template <class Matrix>
Matrix any_weights(Random& random) {
  return Matrix::NullaryExpr([&random] { return random.uniform(-3, 3); });
}

OdometryError any_odometry(Random& random) {
  OdometryError error;
  for (int i = 0; i < 5; ++i) error.arcs.push_back({random.uniform(-0.2, 0.3), random.uniform(-0.3, 0.3)});
  error.steady_sigmas = {0.02, 0.03, 0.04};
  error.root_information = any_weights<Mat3>(random);
  return error;
}

SightingError any_sighting(Random& random) {
  SightingError error{any_place(random), {}, any_weights<Mat2>(random)};
  error.sighting.p_vehicle = any_place(random).position();
  error.sighting.by_tilt = {random.normal(0.1), random.normal(0.1)};
  return error;
}

TEST(LandmarkResiduals, HaveTheDerivativesOfTheirDifferences) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    const Pose2 a = any_place(random), b = any_place(random);
    const double u = random.normal(), v = random.normal(), w = random.normal();
    expect_true_derivatives<3, 3, 3, 3>(any_odometry(random),
                                        {a.x, a.y, a.theta, b.x, b.y, b.theta, u, v, w});
    // Near the angle where it wraps, a residual has no derivative: the loop is off by less than that.
    const LoopError loop{between(a, b) * Pose2{u, v, random.uniform(-3, 3)}};
    expect_true_derivatives<3, 3, 3>(loop, {a.x, a.y, a.theta, b.x, b.y, b.theta});
    expect_true_derivatives<2, 3, 1, 2>(any_sighting(random), {a.x, a.y, a.theta, u, b.x, b.y});
    expect_true_derivatives<2, 2>(KnownError{a.position(), any_weights<Mat2>(random)}, {b.x, b.y});
    expect_true_derivatives<1, 3, 1>(WallError{u, {a.theta + u - v + random.uniform(-3, 3), 0.01}},
                                     {a.x, a.y, a.theta, v});
    expect_true_derivatives<1, 1>(NearZero<1>{}, {u});
    expect_true_derivatives<3, 3>(NearZero<3>{}, {u, v, w});
  }
}

TEST(LandmarkResiduals, AreNoneWhereEverythingAgrees) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose2 key = any_place(random), other = any_place(random);
    const std::array<double, 6> keys{key.x, key.y, key.theta, other.x, other.y, other.theta};
    for (const double off : residual_of<3, 3, 3>(LoopError{between(key, other)}, keys))
      EXPECT_NEAR(off, 0, 1e-9);

    SightingError seen = any_sighting(random);
    const Vec2 p_map = other.position();
    const double tilt = random.normal();
    seen.sighting.p_vehicle = (key * seen.T_key_vehicle).inverse() * p_map + tilt * seen.sighting.by_tilt;
    for (const double off :
         residual_of<2, 3, 1, 2>(seen, std::array{key.x, key.y, key.theta, tilt, p_map.x(), p_map.y()}))
      EXPECT_NEAR(off, 0, 1e-9);

    const double walls_rad = random.normal(), later_rad = random.normal();
    const WallError walls{later_rad, {wrap_angle(key.theta + later_rad - walls_rad), 0.01}};
    EXPECT_NEAR((residual_of<1, 3, 1>(walls, std::array{key.x, key.y, key.theta, walls_rad})[0]), 0, 1e-9);
  }
}

/// The chord of an arc is shorter than the arc, by the 24th part of its turn squared: not seen here.
TEST(LandmarkResiduals, OdometryIsNoneWhereTheVehicleDroveWhatItCountsWithSteadyErrors) {
  constexpr double kLeastTurn = 1e-5;
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Pose2 from = any_place(random);
    OdometryError error{
        .arcs = {}, .steady_sigmas = {0.02, 0.03, 0.04}, .root_information = Mat3::Identity()};
    const Vec3 steady(random.normal(), random.normal(), random.normal());
    const Vec3 off = error.steady_sigmas.cwiseProduct(steady);
    Pose2 to = from;
    for (int arc = 0; arc < 20; ++arc) {
      const bool turns_on_the_spot = arc % 2 == 0;
      const Arc counted = turns_on_the_spot
                              ? Arc{0, random.uniform(-1, 1)}
                              : Arc{random.uniform(-0.3, 0.3), kLeastTurn * random.uniform(-1, 1)};
      error.arcs.push_back(counted);
      const Arc driven{counted.length_m * (1 + off[0]),
                       counted.turn_rad * (1 + off[1]) + counted.length_m * off[2]};
      to = to * end_pose(driven);
    }
    const double bound_m = 20 * 0.4 * square(0.05) / 24;
    const auto residual = residual_of<3, 3, 3, 3>(
        error, std::array{from.x, from.y, from.theta, to.x, to.y, to.theta, steady[0], steady[1], steady[2]});
    EXPECT_NEAR(residual[0], 0, bound_m);
    EXPECT_NEAR(residual[1], 0, bound_m);
    EXPECT_NEAR(residual[2], 0, 1e-12);
  }
}

TEST(LandmarkResiduals, AreTheSameFromEverywhereAndAfterAFullTurn) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Pose2 a = any_place(random), b = any_place(random), p = any_place(random);
    const Pose2 T_moved_map = any_place(random);
    const Pose2 a2 = T_moved_map * a, b2 = T_moved_map * b;
    const Vec2 p2 = T_moved_map * p.position();
    const double turn_rad = 2 * kPi * static_cast<double>(random.index(5));
    const OdometryError odometry = any_odometry(random);
    const LoopError loop{any_place(random)};
    const SightingError seen = any_sighting(random);
    const auto near = [](const auto& here, const auto& there) {
      for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(here[k], there[k], 1e-8);
    };
    near(residual_of<3, 3, 3, 3>(odometry, std::array{a.x, a.y, a.theta, b.x, b.y, b.theta, 0.1, 0.2, 0.3}),
         residual_of<3, 3, 3, 3>(
             odometry, std::array{a2.x, a2.y, a2.theta, b2.x, b2.y, b2.theta + turn_rad, 0.1, 0.2, 0.3}));
    near(residual_of<3, 3, 3>(loop, std::array{a.x, a.y, a.theta, b.x, b.y, b.theta}),
         residual_of<3, 3, 3>(loop, std::array{a2.x, a2.y, a2.theta - turn_rad, b2.x, b2.y, b2.theta}));
    near(residual_of<2, 3, 1, 2>(seen, std::array{a.x, a.y, a.theta, 0.4, p.x, p.y}),
         residual_of<2, 3, 1, 2>(seen, std::array{a2.x, a2.y, a2.theta + turn_rad, 0.4, p2.x(), p2.y()}));
  }
}

TEST(LandmarkAdjustment, ExactDataStayAsTheyAre) {
  MatchedRun run = run_ahead(4);
  for (std::size_t i = 0; i < run.cycles.size(); ++i)
    run.walls.push_back({i, 0, {run.truth[i].theta, 0.5 * kDegree}});
  run.loops.push_back({3, 40, between(run.truth[3], run.truth[40])});
  for (const bool is_known : {false, true}) {
    if (is_known) run.known = run.true_landmarks;
    const Adjusted result = adjusted(run, run.truth, run.true_landmarks);
    for (std::size_t i = 0; i < run.truth.size(); ++i)
      EXPECT_THAT(result.T_map_vehicle[i], PoseNear(run.truth[i], 1e-9, 1e-9)) << i;
    for (std::size_t i = 0; i < run.true_landmarks.size(); ++i) {
      EXPECT_THAT(result.landmarks[i].p_map, PointNear(run.true_landmarks[i].p_map, 1e-9)) << i;
      EXPECT_LT(result.spread[i].norm(), 1e-12) << i;
    }
  }
}

TEST(LandmarkAdjustment, NoisyDataEndNearerToTheTruth) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const MatchedRun run = run_ahead(8, kUsualRun, Random(seed));
    const std::vector<Landmark> begun = run.first_seen(run.counted());
    const Adjusted result = adjusted(run, run.counted(), begun);
    EXPECT_LT(run_rmse_m(result.T_map_vehicle, run.truth), run_rmse_m(run.counted(), run.truth) / 2) << seed;
    EXPECT_LT(landmarks_rmse_m(result.landmarks, run.true_landmarks),
              landmarks_rmse_m(begun, run.true_landmarks) / 2)
        << seed;
    EXPECT_EQ(result.T_map_vehicle[0].x, run.truth[0].x);
    EXPECT_EQ(result.T_map_vehicle[0].y, run.truth[0].y);
    EXPECT_EQ(result.T_map_vehicle[0].theta, run.truth[0].theta);
  }
}

/// By quarter turns, which leave the solver's steps as they are; for all others see the residuals.
TEST(LandmarkAdjustment, MovesAlongWithEverything) {
  constexpr double kTolerance_m = 1e-8;
  MatchedRun run = run_ahead(4, kUsualRun);
  for (std::size_t i = 0; i < run.cycles.size(); ++i)
    run.walls.push_back({i, 0, {run.truth[i].theta, 0.5 * kDegree}});
  run.loops.push_back({3, 40, between(run.truth[3], run.truth[40])});
  const std::vector<Landmark> begun = run.first_seen(run.counted());
  for (const bool is_known : {false, true}) {
    if (is_known) run.known.assign(run.true_landmarks.begin(), run.true_landmarks.begin() + 4);
    for (std::size_t i = 0; i < run.known.size(); ++i)
      run.known[i].covariance << square(0.02), 0.0001, 0.0001, square(0.03);
    const Adjusted there = adjusted(run, run.counted(), begun);
    for (const double turn_rad : {0.0, kPi / 2, kPi, -kPi / 2}) {
      const Pose2 T_moved_map{3.3, -12.4, turn_rad};
      MatchedRun moved = run;
      move_along(T_moved_map, moved.known);
      std::vector<Pose2> poses = run.counted();
      for (Pose2& pose : poses) pose = T_moved_map * pose;
      std::vector<Landmark> landmarks = begun;
      move_along(T_moved_map, landmarks);
      const Adjusted here = adjusted(moved, poses, landmarks);
      const Mat2 R = rotation(turn_rad);
      for (std::size_t i = 0; i < poses.size(); ++i)
        EXPECT_THAT(here.T_map_vehicle[i],
                    PoseNear(T_moved_map * there.T_map_vehicle[i], kTolerance_m, kTolerance_m))
            << i << (is_known ? " known" : " new") << ", turned by " << turn_rad;
      for (std::size_t i = 0; i < landmarks.size(); ++i) {
        EXPECT_THAT(here.landmarks[i].p_map, PointNear(T_moved_map * there.landmarks[i].p_map, kTolerance_m));
        EXPECT_LT((here.landmarks[i].covariance - R * there.landmarks[i].covariance * R.transpose()).norm(),
                  1e-9);
        EXPECT_LT((here.spread[i] - R * there.spread[i] * R.transpose()).norm(), 1e-8);
      }
    }
  }
}

TEST(LandmarkAdjustment, KnownLandmarksHoldTheMapInPlace) {
  MatchedRun run = run_ahead(4);
  run.known = run.true_landmarks;
  const Pose2 T_true_thought{0.1, -0.05, 2 * kDegree};
  std::vector<Pose2> begun = run.truth;
  for (Pose2& pose : begun) pose = T_true_thought * pose;
  const Adjusted result = adjusted(run, begun, run.true_landmarks);
  for (std::size_t i = 0; i < run.truth.size(); ++i)
    EXPECT_THAT(result.T_map_vehicle[i], PoseNear(run.truth[i], 1e-4, 1e-4)) << i;
}

/// The vehicle stands and looks at one landmark ahead, which is off by this along x and y in each image.
MatchedRun standing_run(const std::vector<Vec2>& off_m, double sigma_m) {
  MatchedRun run;
  run.true_landmarks.resize(1);
  run.true_landmarks[0].p_map = {2, 0};
  for (const Vec2& off : off_m) {
    LandmarkSighting sighting;
    sighting.p_vehicle = Vec2(2, 0) + off;
    sighting.covariance = square(sigma_m) * Mat2::Identity();
    run.observations.push_back({run.cycles.size(), 0, 0});
    run.cycles.emplace_back();
    run.cycles.back().odometry = FrontSteeredMotion{};
    run.cycles.back().sightings.push_back(sighting);
    run.truth.emplace_back();
  }
  run.cycles.emplace_back();  // the last pose is an unknown: it sees nothing
  run.cycles.back().odometry = FrontSteeredMotion{};
  run.truth.emplace_back();
  return run;
}

/// One of two known landmarks ahead is 2 mm nearer to the other than it was: both sightings are the surer.
TEST(LandmarkAdjustment, KnownLandmarksHoldAsFirmlyAsTheyAreKnown) {
  constexpr double kFirm_m = 0.01, kLoose_m = 0.02, kLeast_m = 0.002, kOff_m = 0.002;
  MatchedRun run = standing_run(std::vector<Vec2>(4, Vec2::Zero()), 1e-4);
  run.true_landmarks.push_back(run.true_landmarks[0]);
  run.true_landmarks[1].p_map = {4, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    run.cycles[i].sightings.push_back(run.cycles[i].sightings[0]);
    run.cycles[i].sightings[1].p_vehicle = {4, 0};
    run.observations.push_back({i, 1, 1});
  }
  run.known = run.true_landmarks;
  run.known[0].covariance = square(kFirm_m) * Mat2::Identity();
  run.known[1].covariance = square(kLoose_m) * Mat2::Identity();
  run.known[0].p_map.x() += kOff_m;
  const double firm = 1 / (square(kFirm_m) + square(kLeast_m));
  const double loose = 1 / (square(kLoose_m) + square(kLeast_m));
  const Adjusted result = adjusted(run, run.truth, run.known);
  const Vec2 moved{kOff_m * firm / (firm + loose), 0};
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_THAT(result.landmarks[i].p_map, PointNear(run.true_landmarks[i].p_map + moved, 1e-5));
}

TEST(LandmarkAdjustment, SightingsLeaveTheCovarianceOfTheirMean) {
  const std::vector<Vec2> off_m(9, Vec2::Zero());
  MatchedRun run = standing_run(off_m, 0.03);
  EXPECT_LT(
      (adjusted(run, run.truth, run.true_landmarks).landmarks[0].covariance - square(0.01) * Mat2::Identity())
          .norm(),
      1e-12);
  run.known = run.true_landmarks;
  const double known_m2 = square(0.01) - square(0.002);  // it is never known better than to 2 mm
  run.known[0].covariance = known_m2 * Mat2::Identity();
  EXPECT_LT((adjusted(run, run.truth, run.true_landmarks).landmarks[0].covariance -
             square(0.01) / 2 * Mat2::Identity())
                .norm(),
            1e-12);
}

TEST(LandmarkAdjustment, SpreadIsWhatTheirOwnErrorsDoNotExplainInTheMap) {
  const MatchedRun run = standing_run({{0.03, 0}, {-0.03, 0}, {0.03, 0}, {-0.03, 0}}, 0.02);
  const Pose2 T_map_start{1, 2, kPi / 2};
  std::vector<Pose2> poses(run.truth.size(), T_map_start);
  std::vector<Landmark> landmarks = run.true_landmarks;
  move_along(T_map_start, landmarks);
  const Adjusted result = adjusted(run, poses, landmarks);
  Mat2 expected = Mat2::Zero();
  expected(1, 1) = square(0.03) - square(0.02);
  EXPECT_LT((result.spread[0] - expected).norm(), 1e-9);
}

/// How far poses and landmarks are displaced by one sighting that is off to its left by this much [m].
double displaced_by_sighting_off_m(double off_m) {
  MatchedRun run = run_ahead(4);
  const LandmarkObservation& wrong = run.observations[run.observations.size() / 2];
  run.cycles[wrong.cycle].sightings[wrong.sighting].p_vehicle.y() += off_m;
  const Adjusted result = adjusted(run, run.truth, run.true_landmarks);
  return run_rmse_m(result.T_map_vehicle, run.truth) + landmarks_rmse_m(result.landmarks, run.true_landmarks);
}

TEST(LandmarkAdjustment, ASightingFarOffIsOutweighed) {
  const double near_m = displaced_by_sighting_off_m(0.05), far_m = displaced_by_sighting_off_m(1);
  EXPECT_GT(near_m, 1e-6) << "a sighting that hardly matters shows nothing";
  EXPECT_LT(far_m, near_m);
}

/// How far the end of 8 m straight ahead, known by odometry alone, is displaced by a loop that ends farther
/// ahead [m].
double displaced_by_loop_off_m(double off_m) {
  MatchedRun run;
  Random random(1);
  for (int i = 0; i <= 100; ++i) run.move({i == 0 ? 0 : kAdjustedStep_m, 0}, {}, random);
  run.loops.push_back({0, 100, Pose2{8 + off_m, 0, 0}});
  return adjusted(run, run.truth, {}).T_map_vehicle.back().x - 8;
}

TEST(LandmarkAdjustment, ALoopBringsDriftBackButPullsNoHarderTheFartherItIsOff) {
  const FrontSteeredNoise noise = corridor_cart().front_steered_noise;
  const double odometry_m2 = square(noise.distance_scale * 8) + square(noise.distance_slip_m_per_sqrt_m) * 8 +
                             100 * square(noise.distance_quantum_m) / 6;
  const double loop_m2 = square(LoopError::kSigma_m);
  EXPECT_NEAR(displaced_by_loop_off_m(0.05), 0.05 * odometry_m2 / (odometry_m2 + loop_m2), 1e-4);
  const double limit_m = 3 * odometry_m2 / LoopError::kSigma_m;  // where a loop off by 3 sigmas pulls it
  EXPECT_NEAR(displaced_by_loop_off_m(2), limit_m, 0.01 * limit_m);
  EXPECT_NEAR(displaced_by_loop_off_m(4), limit_m, 0.01 * limit_m);
}

TEST(LandmarkAdjustment, WallsOfUnknownDirectionHoldTheHeading) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    MatchedRun run = run_ahead(8, kUsualRun, Random(seed));
    run.observations.clear();
    const double walls_rad = 0.4;
    for (std::size_t i = 0; i < run.cycles.size(); ++i)
      run.walls.push_back({i, 0, {wrap_angle(run.truth[i].theta - walls_rad), 0.2 * kDegree}});
    const auto off_rad = [&](const Pose2& pose) {
      return std::abs(wrap_angle(pose.theta - run.truth.back().theta));
    };
    const Adjusted result = adjusted(run, run.counted(), run.true_landmarks);
    EXPECT_LT(off_rad(result.T_map_vehicle.back()), off_rad(run.counted().back()) / 3) << seed;
  }
}

}  // namespace
}  // namespace aisle
