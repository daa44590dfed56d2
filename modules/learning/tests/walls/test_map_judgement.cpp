#include "aisle/learning/walls/map_judgement.hpp"

#include <gtest/gtest.h>

#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

WallMap map_of(const std::vector<Segment2>& segments) {
  WallMap map;
  for (const Segment2& segment : segments) map.walls.push_back({.segment = segment});
  return map;
}

std::vector<Pose2> true_path(const LaserLog& log) {
  std::vector<Pose2> path;
  for (const LaserScan& scan : log.scans) path.push_back(on_figure_of_eight(scan.time_s));
  return path;
}

/// A log of one scan with these readings, in steps of 90 degrees.
LaserLog single_scan(std::vector<float> ranges_m) {
  LaserLog log;
  log.laser() = {0, 90 * kDegree, 30, {}};
  log.scans.push_back({.ranges_m = std::move(ranges_m)});
  return log;
}

MapJudgement judge_single(const std::vector<Segment2>& walls, const std::vector<float>& ranges_m) {
  return judge_map(map_of(walls), single_scan(ranges_m), std::vector<Pose2>{{}});
}

TEST(MapJudgement, ATrueMapIsGood) {
  const LaserLog log = RecordedDrive{.range_sigma_m = 0.02}.log();
  const MapJudgement judgement = judge_map(map_of(uneven_room()), log, true_path(log));
  EXPECT_GT(judgement.fit_share, 0.99);
  EXPECT_LT(judgement.pass_share, 0.005);
  EXPECT_EQ(trust_in(judgement), Trust::kGood);
}

TEST(MapJudgement, AMapDrawnTwiceIsPoor) {
  const LaserLog log = RecordedDrive{}.log();
  std::vector<Segment2> walls = uneven_room();
  for (const Segment2& wall : uneven_room()) walls.push_back(Pose2{1, 0.8, 5 * kDegree} * wall);
  const MapJudgement judgement = judge_map(map_of(walls), log, true_path(log));
  EXPECT_GT(judgement.fit_share, 0.99) << "each reading still has its wall";
  EXPECT_EQ(trust_in(judgement), Trust::kPoor);
}

TEST(MapJudgement, AMapAtAnotherPlaceIsPoor) {
  const LaserLog log = RecordedDrive{}.log();
  std::vector<Segment2> walls = uneven_room();
  for (Segment2& wall : walls) wall = Pose2{0.5, 0.5, 10 * kDegree} * wall;
  EXPECT_EQ(trust_in(judge_map(map_of(walls), log, true_path(log))), Trust::kPoor);
}

TEST(MapJudgement, AMapWithoutWallsIsPoor) {
  const LaserLog log = RecordedDrive{}.log();
  const MapJudgement judgement = judge_map({}, log, true_path(log));
  EXPECT_EQ(judgement.fit_share, 0);
  EXPECT_EQ(judgement.pass_share, 0);
  EXPECT_EQ(trust_in(judgement), Trust::kPoor);
}

TEST(MapJudgement, IsTheSameInAnyFrame) {
  const Pose2 T_other_map{-40, 9, 2};
  const LaserLog log = RecordedDrive{.laser = {-135 * kDegree, 1 * kDegree, 30, {0.3, 0.1, 1}}}.log();
  std::vector<Segment2> walls = uneven_room();
  walls.resize(9);
  std::vector<Pose2> path = true_path(log);
  const MapJudgement here = judge_map(map_of(walls), log, path);
  for (Segment2& wall : walls) wall = T_other_map * wall;
  for (Pose2& pose : path) pose = T_other_map * pose;
  const MapJudgement there = judge_map(map_of(walls), log, path);
  EXPECT_NEAR(there.fit_share, here.fit_share, 1e-3);
  EXPECT_NEAR(there.pass_share, here.pass_share, 1e-3);
  EXPECT_LT(here.fit_share, 0.97) << "some walls are missing";
}

TEST(MapJudgement, SharesByHand) {
  const std::vector<Segment2> ahead = {{{2, -1}, {2, 1}}};
  EXPECT_EQ(judge_single(ahead, {2.09F}).fit_share, 1);
  EXPECT_EQ(judge_single(ahead, {2.11F}).fit_share, 0);
  EXPECT_EQ(judge_single(ahead, {2.29F}).pass_share, 0) << "30 cm behind a wall is not through it";
  EXPECT_EQ(judge_single(ahead, {2.31F}).pass_share, 1);
  const MapJudgement both = judge_single(ahead, {2, 2, 9, 9});  // ahead, left, back, right
  EXPECT_EQ(both.fit_share, 0.25);
  EXPECT_EQ(both.pass_share, 0);
}

TEST(MapJudgement, LooksThroughTheWholeLengthOfABeam) {
  for (const float wall_m : {0.1F, 1.0F, 7.5F, 13.9F})
    EXPECT_EQ(judge_single({{{wall_m, -1}, {wall_m, 1}}}, {14.5F}).pass_share, 1) << "at " << wall_m;
}

TEST(MapJudgement, CountsReadingsBetweenTheVehicleItselfAndFifteenMetres) {
  EXPECT_EQ(judge_single({}, {0, 0.04F, 15.1F, 30}).readings, 0U);
  EXPECT_EQ(judge_single({}, {0.06F, 14.9F, 30, 1}).readings, 3U);
  EXPECT_EQ(judge_map({}, LaserLog{}, {}).readings, 0U);
}

TEST(MapJudgement, SamplesALongLog) {
  const LaserLog log = RecordedDrive{.duration_s = 120}.log();
  const MapJudgement judgement = judge_map(map_of(uneven_room()), log, true_path(log));
  EXPECT_GT(judgement.readings, 300U * 60);
  EXPECT_LT(judgement.readings, 600U * 120);
}

TEST(TrustIn, FewReadingsAreNotJudged) {
  EXPECT_EQ(trust_in({0, 1, 999}), Trust::kUnknown);
  EXPECT_EQ(trust_in({0, 1, 1000}), Trust::kPoor);
  EXPECT_EQ(trust_in({}), Trust::kUnknown);
}

TEST(TrustIn, NeverRisesWithWorseShares) {
  constexpr std::size_t kReadings = 5000;
  const auto rank = [](double fit, double pass) {
    return static_cast<int>(trust_in({fit, pass, kReadings}));
  };
  for (double fit = 0; fit <= 0.95; fit += 0.05) {
    for (double pass = 0; pass <= 0.95; pass += 0.01) {
      EXPECT_LE(rank(fit + 0.05, pass), rank(fit, pass));
      EXPECT_LE(rank(fit, pass), rank(fit, pass + 0.01));
    }
  }
  EXPECT_EQ(trust_in({1, 0, kReadings}), Trust::kGood);
  EXPECT_EQ(trust_in({0.9, 0.06, kReadings}), Trust::kDoubtful);
  EXPECT_EQ(trust_in({0.4, 0.01, kReadings}), Trust::kDoubtful);
  EXPECT_EQ(trust_in({0.9, 0.1, kReadings}), Trust::kPoor);
  EXPECT_EQ(trust_in({0.2, 0, kReadings}), Trust::kPoor);
}

}  // namespace
}  // namespace aisle
