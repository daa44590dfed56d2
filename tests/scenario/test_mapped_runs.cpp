#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>

#include "pose_matchers.hpp"
#include "recorded_runs.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::Not;

std::string camel_case(const testing::TestParamInfo<const char*>& world) {
  std::string name;
  for (const char* c = world.param; *c; ++c) {
    if (*c == '-') continue;
    const bool begins_word = c == world.param || c[-1] == '-';
    name += static_cast<char>(begins_word ? std::toupper(*c) : *c);
  }
  return name;
}

bool are_same(const Pose2& a, const Pose2& b) {
  return a.x == b.x && a.y == b.y && a.theta == b.theta;
}

/// The first scans of a log, with what had been recorded by then.
LaserLog beginning_of(const LaserLog& log, std::size_t scans) {
  LaserLog beginning{
      log.lasers, {log.scans.begin(), log.scans.begin() + static_cast<std::ptrdiff_t>(scans)}, {}};
  const auto known = static_cast<std::ptrdiff_t>(beginning.scans.back().odometry_known);
  beginning.odometry = {log.odometry.begin(), log.odometry.begin() + known};
  return beginning;
}

class MappedOffice : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Worlds, MappedOffice, testing::Values("small-office", "two-loops"), camel_case);

TEST_P(MappedOffice, IsRightToTwoCentimetresAndBetterThanByThePublishedRules) {
  const TourRecording run = recorded(GetParam());
  const double refined_m = error_m(mapped(run.log).T_map_vehicle, run);
  EXPECT_LT(refined_m, 0.02);
  EXPECT_LT(refined_m, error_m(mapped_as_published(run.log).T_map_vehicle, run));
}

TEST_P(MappedOffice, HasItsDirectionItsLoopsAndNoDelay) {
  const MapResult result = mapped(recorded(GetParam()).log);
  EXPECT_TRUE(result.has_dominant_direction);
  EXPECT_THAT(result.loop_closures, Not(IsEmpty()));
  EXPECT_GT(result.walls.orthogonal_share(), 0.9);
  EXPECT_EQ(result.odometry_delay_s, 0);
}

TEST_P(MappedOffice, TheSameLogGivesTheSameMapToTheLastBit) {
  const LaserLog log = recorded(GetParam()).log;
  const MapResult a = mapped(log), b = mapped(log);
  EXPECT_TRUE(std::equal(a.T_map_vehicle.begin(), a.T_map_vehicle.end(), b.T_map_vehicle.begin(), are_same));
  EXPECT_EQ(a.loop_closures, b.loop_closures);
  ASSERT_EQ(a.walls.walls.size(), b.walls.walls.size());
  for (std::size_t i = 0; i < a.walls.walls.size(); ++i) {
    EXPECT_EQ(a.walls.walls[i].segment.start, b.walls.walls[i].segment.start);
    EXPECT_EQ(a.walls.walls[i].segment.end, b.walls.walls[i].segment.end);
  }
}

TEST_P(MappedOffice, PosesKnownWhileDrivingRestOnNothingThatComesLater) {
  const LaserLog log = recorded(GetParam()).log;
  const std::vector<Pose2> online = mapped(log).T_map_vehicle_online;
  ASSERT_EQ(online.size(), log.scans.size());
  for (const std::size_t scans : {std::size_t{1}, log.scans.size() / 3, log.scans.size() - 1}) {
    const std::vector<Pose2> earlier = mapped(beginning_of(log, scans)).T_map_vehicle_online;
    ASSERT_EQ(earlier.size(), scans);
    for (std::size_t i = 0; i < scans; ++i) ASSERT_THAT(earlier[i], PoseNear(online[i], 1e-6, 1e-6)) << i;
  }
}

TEST_P(MappedOffice, PosesKnownWhileDrivingAreNearlyAsExactAsTheFinalOnes) {
  const TourRecording run = recorded(GetParam());
  const MapResult result = mapped(run.log);
  EXPECT_LT(error_m(result.T_map_vehicle_online, run), error_m(result.T_map_vehicle, run) + 0.006);
}

TEST_P(MappedOffice, WithoutNoisePosesKnownWhileDrivingAreTheFinalOnes) {
  TourParams exact;
  exact.odometry = {0, 0, 0, 0, 0, 0};
  RangeSensorParams& sensor = exact.scanner.sensor;
  sensor.noise_sigma_m = sensor.resolution_m = sensor.dropped_share = 0;
  const TourRecording run = recorded(GetParam(), exact);
  const MapResult result = mapped(run.log);
  const std::vector<Pose2>& online = result.T_map_vehicle_online;
  const std::vector<Pose2>& last = result.T_map_vehicle;
  ASSERT_EQ(online.size(), last.size());
  for (std::size_t i = 0; i < last.size(); ++i) ASSERT_THAT(online[i], PoseNear(last[i], 0.05, kDegree)) << i;
  EXPECT_NEAR(error_m(online, run), error_m(last, run), 0.003);
}

TEST(MappedRun, ADelayOfTheOdometryIsFoundAndDoesNoHarm) {
  for (const double delay_s : {-0.1, 0.13}) {
    TourParams params;
    params.odometry_delay_s = delay_s;
    const TourRecording run = recorded("small-office", params);
    const MapResult result = mapped(run.log);
    EXPECT_NEAR(result.odometry_delay_s, delay_s, 0.0301);
    EXPECT_LT(error_m(result.T_map_vehicle, run), 0.02);
  }
}

TEST(MappedRun, ARoundHallIsSaidToHaveNoDominantDirectionAndIsMappedAllTheSame) {
  const TourRecording run = recorded("round-hall");
  const MapResult result = mapped(run.log);
  EXPECT_FALSE(result.has_dominant_direction);
  EXPECT_EQ(result.walls.orthogonal_share(), 0);
  EXPECT_LT(error_m(result.T_map_vehicle, run), 0.05);
}

}  // namespace
}  // namespace aisle
