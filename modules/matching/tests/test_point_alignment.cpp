#include "aisle/matching/point_alignment.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"
#include "cast_scans.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using Surface = std::vector<SurfacePoint>;

Surface surface_of(const std::vector<Vec2>& points) {
  Surface surface;
  surface_points(points, surface);
  return surface;
}

Surface surface_seen(const std::vector<Segment2>& walls, const Pose2& T_map_sensor) {
  return surface_of(cast_points(walls, T_map_sensor));
}

SurfaceMap map_seen_from(const std::vector<Segment2>& walls, const std::vector<Pose2>& places) {
  SurfaceMap map;
  for (const Pose2& place : places) map.add(surface_seen(walls, place), place);
  return map;
}

const Pose2 kSeenFrom{3, 2, 0.7};

SurfaceMap room_map() {
  return map_seen_from(uneven_room(), {kSeenFrom});
}

/// `count` points on the wall x = 2, `step_m` apart, seen from the origin.
std::vector<Vec2> on_wall_ahead(int count, double step_m = 0.05) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back({2, (i - count / 2) * step_m});
  return points;
}

TEST(SurfacePoints, OfAWallFaceTheSensorSquarely) {
  const Surface surface = surface_of(on_wall_ahead(21));
  ASSERT_EQ(surface.size(), 21U);
  for (const SurfacePoint& point : surface) EXPECT_THAT(point.normal, PointNear(Vec2(-1, 0), 1e-9));
}

RC_GTEST_PROP(SurfacePoints, OfARoundRoomPointAtItsCentre, (std::uint64_t seed)) {
  Random random(seed);
  const double radius_m = random.uniform(0.5, 3), first_rad = random.uniform(-kPi, kPi);
  std::vector<Vec2> points;
  for (int i = 0; i < 180; ++i) points.push_back(radius_m * unit(first_rad + 2 * i * kDegree));
  for (const SurfacePoint& point : surface_of(points)) {
    RC_ASSERT(std::abs(point.normal.norm() - 1) < 1e-9);
    RC_ASSERT(point.normal.dot(-point.p.normalized()) > std::cos(10 * kDegree));
  }
}

TEST(SurfacePoints, LeaveOutLonelyPointsAndThoseTooNearToAnother) {
  std::vector<Vec2> points = on_wall_ahead(21);
  points.push_back({5, 3});
  EXPECT_EQ(surface_of(points).size(), 21U);
  EXPECT_EQ(surface_of(on_wall_ahead(101, 0.0055)).size(), 26U);
  EXPECT_TRUE(surface_of({}).empty());
  EXPECT_TRUE(surface_of({{1, 1}}).empty());
  EXPECT_TRUE(surface_of({{1, 1}, {1, 1}, {1, 1}}).empty());
}

TEST(SurfacePoints, SpanNoGapBetweenSurfaces) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 10; ++i) points.push_back({1, -0.3 + 0.03 * i});
  for (int i = 0; i <= 10; ++i) points.push_back({3, 0.1 + 0.06 * i});
  for (const SurfacePoint& point : surface_of(points))
    EXPECT_THAT(point.normal, PointNear(Vec2(-1, 0), 1e-9));
}

TEST(SurfacePoints, SpanNoBeamsThatSawNothing) {
  for (const SurfacePoint& point : surface_seen(endless_corridor(), {}))
    EXPECT_NEAR(std::abs(point.normal.y()), 1, 1e-6) << "at x " << point.p.x();
}

TEST(SurfaceMap, FindsWhatTryingAllPointsFinds) {
  Random random(1);
  SurfaceMap map;
  const Surface surface = surface_seen(uneven_room(), kSeenFrom);
  map.add(surface, {});
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p(random.uniform(-5, 6), random.uniform(-5, 6)), normal = unit(random.uniform(-kPi, kPi));
    const double reach_m = random.uniform(0.02, SurfaceMap::kCell_m);
    double nearest_m = reach_m;
    for (const SurfacePoint& point : surface) {
      if (point.normal.dot(normal) >= 0.7) nearest_m = std::min(nearest_m, (point.p - p).norm());
    }
    const SurfacePoint* found = map.nearest(p, normal, reach_m);
    ASSERT_EQ(found != nullptr, nearest_m < reach_m);
    ASSERT_NEAR(found != nullptr ? (found->p - p).norm() : reach_m, nearest_m, 1e-12);
  }
}

TEST(SurfaceMap, KeepsPointsWhereTheSensorSawThem) {
  SurfaceMap map;
  EXPECT_TRUE(map.empty());
  map.add(Surface{{{2, 0}, {-1, 0}}}, {1, 1, kPi / 2});
  const SurfacePoint* point = map.nearest({1, 3.05}, {0, -1}, 0.1);
  ASSERT_NE(point, nullptr);
  EXPECT_THAT(point->p, PointNear(Vec2(1, 3), 1e-12));
  EXPECT_THAT(point->normal, PointNear(Vec2(0, -1), 1e-12));
  EXPECT_EQ(map.nearest({1, 3.05}, {0, 1}, 0.1), nullptr) << "the other side of the wall";
  EXPECT_EQ(map.nearest({1, 3.15}, {0, -1}, 0.1), nullptr);
}

TEST(SurfaceMap, APointBesideAKnownOneAddsNothing) {
  SurfaceMap map;
  map.add(Surface{{{2, 0}, {-1, 0}}}, {});
  map.add(Surface{{{2, 0.015}, {-1, 0}}}, {});
  EXPECT_THAT(map.nearest({2, 0.015}, {-1, 0}, 0.1)->p, PointNear(Vec2(2, 0), 0));
}

TEST(SurfaceMap, ForgetsWhatItHasNotSeenForLong) {
  SurfaceMap map;
  map.add(Surface{{{2, 0}, {-1, 0}}}, {});
  const Surface elsewhere = {{{9, 0}, {-1, 0}}};
  const auto is_known = [&] { return map.nearest({2, 0}, {-1, 0}, 0.1) != nullptr; };
  for (int i = 1; i < SurfaceMap::kScansKept; ++i) map.add(elsewhere, {});
  EXPECT_TRUE(is_known());
  for (int i = 0; i <= SurfaceMap::kScansKept / 4; ++i) map.add(elsewhere, {});
  EXPECT_FALSE(is_known());
  map.for_each_near_cell([](const Vec2& p) { EXPECT_GT(p.x(), 5); });
}

TEST(SurfaceMap, ItsNearCellsAreThoseAtAndBesideItsPoints) {
  SurfaceMap map;
  map.add(Surface{{{-2.01, 0.52}, {1, 0}}}, {});
  std::vector<Vec2> cells;
  map.for_each_near_cell([&](const Vec2& p) { cells.push_back(p); });
  ASSERT_EQ(cells.size(), 9U);
  for (const Vec2& cell : cells) EXPECT_LT((cell - Vec2(-2, 0.5)).lpNorm<Eigen::Infinity>(), 0.11);
}

TEST(FitSurface, TheTruthIsItsFixedPoint) {
  const SurfaceFit fit =
      fit_surface(surface_seen(uneven_room(), kSeenFrom), room_map(), kSeenFrom, Mat3::Zero());
  EXPECT_THAT(fit.T_map_sensor, PoseNear(kSeenFrom, 1e-6, 1e-6));
  EXPECT_EQ(fit.share, 1);
}

RC_GTEST_PROP(FitSurface, FindsAMoveNearby, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 truth = kSeenFrom * Pose2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2),
                                        random.uniform(-8, 8) * kDegree};
  static const SurfaceMap map = room_map();
  const SurfaceFit fit = fit_surface(surface_seen(uneven_room(), truth), map, kSeenFrom, Mat3::Zero());
  RC_ASSERT((fit.T_map_sensor.position() - truth.position()).norm() < 0.02);
  RC_ASSERT(std::abs(wrap_angle(fit.T_map_sensor.theta - truth.theta)) < 0.5 * kDegree);
  RC_ASSERT(fit.share > 0.9);
}

TEST(FitSurface, ACommonMotionOfMapAndScanMovesTheFitAlong) {
  const Pose2 T_moved_map{-7, 4, 2.2}, truth = kSeenFrom * Pose2{0.1, 0.05, 4 * kDegree};
  SurfaceMap moved;
  moved.add(surface_seen(uneven_room(), kSeenFrom), T_moved_map * kSeenFrom);
  const Surface surface = surface_seen(uneven_room(), truth);
  const SurfaceFit here = fit_surface(surface, room_map(), kSeenFrom, Mat3::Zero());
  const SurfaceFit there = fit_surface(surface, moved, T_moved_map * kSeenFrom, Mat3::Zero());
  EXPECT_THAT(there.T_map_sensor, PoseNear(T_moved_map * here.T_map_sensor, 1e-4, 1e-4));
  EXPECT_NEAR(there.share, here.share, 1e-9);
}

/// What the fit minimises, of the distances from the lines through the nearest points.
double cauchy_cost(const Surface& surface, const SurfaceMap& map, const Pose2& T_map_sensor,
                   const Pose2& T_matched) {
  constexpr double kSigma_m = 0.03, kCauchy_m = 0.05, kReach_m = 0.1;
  double cost = 0;
  for (const SurfacePoint& point : surface) {
    const SurfacePoint* known =
        map.nearest(T_matched * point.p, rotate(T_matched.theta, point.normal), kReach_m);
    if (known == nullptr) continue;
    const double off_m = known->normal.dot(T_map_sensor * point.p - known->p);
    cost += square(kCauchy_m / kSigma_m) * std::log1p(square(off_m / kCauchy_m)) / 2;
  }
  return cost;
}

TEST(FitSurface, EndsWhereTheNumericalDerivativeOfItsCostVanishes) {
  Random random(3);
  Surface surface = surface_seen(uneven_room(), kSeenFrom * Pose2{0.05, 0.1, 3 * kDegree});
  surface.resize(std::min<std::size_t>(surface.size(), 190));  // fewer than are thinned out
  for (SurfacePoint& point : surface) point.p += 0.02 * Vec2(random.normal(), random.normal());
  const SurfaceMap map = room_map();
  const SurfaceFit fit = fit_surface(surface, map, kSeenFrom, Mat3::Zero());
  constexpr double kProbed = 1e-5;
  for (int unknown = 0; unknown < 3; ++unknown) {
    const auto cost_at = [&](double change) {
      return cauchy_cost(surface, map, moved_by(fit.T_map_sensor, change * Vec3::Unit(unknown)),
                         fit.T_map_sensor);
    };
    const double slope = (cost_at(kProbed) - cost_at(-kProbed)) / (2 * kProbed);
    EXPECT_LT(std::abs(slope) / fit.information(unknown, unknown), 2e-4) << "unknown " << unknown;
  }
}

TEST(FitSurface, InformationIsOneSummandAPointByHand) {
  const Surface surface = surface_of(on_wall_ahead(21));
  SurfaceMap map;
  map.add(surface, {});
  const Mat3 information = fit_surface(surface, map, {}, Mat3::Zero()).information;
  const double point = 1 / square(0.03);
  double lever_m2 = 0;
  for (const SurfacePoint& p : surface) lever_m2 += square(p.p.y());
  EXPECT_NEAR(information(0, 0), 21 * point, 1e-6);
  EXPECT_NEAR(information(1, 1), 0, 1e-6);
  EXPECT_NEAR(information(2, 2), lever_m2 * point, 1e-6);
}

TEST(FitSurface, TheGuessRulesWhereTheWallsSayNothing) {
  const SurfaceMap map = map_seen_from(endless_corridor(), {{0, 0, 0}});
  const Surface surface = surface_seen(endless_corridor(), {0.2, 0.1, 0});
  const Mat3 sure = Vec3(1e4, 1e4, 1e4).asDiagonal();
  const SurfaceFit fit = fit_surface(surface, map, {0.15, 0.05, 1 * kDegree}, sure);
  EXPECT_NEAR(fit.T_map_sensor.x, 0.15, 0.005);
  EXPECT_NEAR(fit.T_map_sensor.y, 0.1, 0.01);
  const SurfaceFit certain = fit_surface(surface, map, {0.15, 0.05, 0}, 1e12 * Mat3::Identity());
  EXPECT_THAT(certain.T_map_sensor, PoseNear(Pose2{0.15, 0.05, 0}, 1e-5, 1e-5));
}

TEST(FitSurface, OfNothingOrOntoNothingIsTheGuess) {
  const Surface surface = surface_seen(uneven_room(), kSeenFrom);
  for (const SurfaceFit& fit :
       {fit_surface({}, room_map(), kSeenFrom, Mat3::Zero()),
        fit_surface(surface, {}, kSeenFrom, Mat3::Zero()), fit_surface_far({}, room_map(), kSeenFrom, {}),
        fit_surface_far(surface, {}, kSeenFrom, {})}) {
    EXPECT_THAT(fit.T_map_sensor, PoseNear(kSeenFrom, 0, 0));
    EXPECT_EQ(fit.share, 0);
    EXPECT_EQ(fit.information, Mat3::Zero());
  }
}

TEST(FitSurfaceFar, FindsWhatIsTooFarForAFitNearby) {
  const SurfaceMap map = room_map();
  for (const Pose2& off :
       {Pose2{0.5, 0.4, 0}, Pose2{-0.3, 0.2, 40 * kDegree}, Pose2{0, -0.5, -35 * kDegree}}) {
    const Surface surface = surface_seen(uneven_room(), kSeenFrom);
    const SurfaceFit near = fit_surface(surface, map, kSeenFrom * off, Mat3::Zero());
    const SurfaceFit far = fit_surface_far(surface, map, kSeenFrom * off, {});
    EXPECT_THAT(far.T_map_sensor, PoseNear(kSeenFrom, 0.01, 0.2 * kDegree));
    EXPECT_GT(far.share, near.share - 1e-9);
  }
}

TEST(FitSurfaceFar, LooksNoFartherThanItMay) {
  const SearchReach reach{.position_m = 0.2, .heading_rad = 5 * kDegree};
  const Pose2 guess = kSeenFrom * Pose2{1.5, 1, 50 * kDegree};
  const SurfaceFit fit = fit_surface_far(surface_seen(uneven_room(), kSeenFrom), room_map(), guess, reach);
  EXPECT_LT((fit.T_map_sensor.position() - guess.position()).norm(), 0.9);
  EXPECT_LT(fit.share, 0.7);
}

}  // namespace
}  // namespace aisle
