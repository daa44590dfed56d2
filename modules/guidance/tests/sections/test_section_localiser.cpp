#include "aisle/guidance/sections/section_localiser.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// A corridor 1.2 m wide along x, whose right base line ends at x = 4.3 m; a wall across it at 5.5 m. The
/// path turns right at 5 m.
const SectionList kSections = {
    {.kind = Section::Kind::kHybrid, .length_m = 5, .right_m = 0.5, .left_m = 0.7, .ahead_m = 0.5},
    {.kind = Section::Kind::kTurn, .turn_rad = -kPi / 2},
    {.kind = Section::Kind::kFollow, .length_m = 3, .right_m = 0.7, .left_m = 0.5}};
const Segment2 kRight{{0, -0.5}, {4.3, -0.5}};
const Segment2 kLeft{{5.5, 0.7}, {0, 0.7}};
const Segment2 kEndWall{{5.5, -0.5}, {5.5, 0.7}};

SensedSegment seen_from(const Pose2& T_map_vehicle, const Segment2& wall) {
  const Segment2 segment = T_map_vehicle.inverse() * wall;
  return {.segment = segment,
          .centroid = segment.midpoint(),
          .heading_rad = segment.heading(),
          .length_m = segment.length(),
          .sigma_offset_m = 0.01,
          .sigma_heading_rad = 0.5 * kDegree};
}

VehicleDescription two_wheels() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

/// The estimated position of a vehicle that started 4 cm too far to the left and drove to x = 4 m, while its
/// wheels counted a tenth of a metre too little, after it has looked at the walls there.
Vec2 believed(const std::vector<Segment2>& walls, const SectionLocaliserParams& params = {}) {
  const GuidedPath path = guided_path(kSections, {}, SectionRun::kThere);
  const VehicleDescription vehicle = two_wheels();
  SectionLocaliser localiser(params, vehicle, path);
  const int steps = static_cast<int>(std::lround(3.9 / vehicle.differential.step_length_m() / 100));
  for (int i = 0; i < 100; ++i) localiser.predict(WheelSteps{steps, steps});
  const Pose2 T_map_vehicle{4, 0.04, 0};
  std::vector<SensedSegment> edges;
  for (const Segment2& wall : walls) edges.push_back(seen_from(T_map_vehicle, wall));
  for (int i = 0; i < 60; ++i) localiser.correct(edges, 0);
  return localiser.pose().position();
}

TEST(SectionLocaliser, BaseLinesBesideCorrectTheLateralPosition) {
  for (const Segment2& wall : {kRight, kLeft}) EXPECT_NEAR(believed({wall}).y(), 0.04, 0.01);
  EXPECT_NEAR(believed({kLeft}, {.left_base_line = false}).y(), 0, 1e-6);
}

TEST(SectionLocaliser, FindsItsBaseLinesWithACrossTrackError) {
  const GuidedPath path = guided_path(kSections, {}, SectionRun::kThere);
  SectionLocaliser localiser({}, two_wheels(), path);
  constexpr double kLateral_m = 0.3;
  for (int i = 0; i < 60; ++i) {
    localiser.predict(WheelSteps{22, 22});
    const Pose2 T_map_vehicle{localiser.pose().x, kLateral_m, 0};
    localiser.correct(std::vector{seen_from(T_map_vehicle, kRight), seen_from(T_map_vehicle, kLeft)}, 0);
  }
  EXPECT_NEAR(localiser.pose().y, kLateral_m, 0.05);
}

TEST(SectionLocaliser, TheWallAheadCorrectsTheLongitudinalPosition) {
  EXPECT_NEAR(believed({kEndWall}).x(), 4, 0.02);
  EXPECT_NEAR(believed({kEndWall}, {.length_by_wall_ahead = false}).x(), 3.9, 0.02);
}

TEST(SectionLocaliser, AcceptsAWallFarFromItsExpectedPlaceAfterALongPath) {
  const SectionList sections = {
      {.kind = Section::Kind::kFollow, .length_m = 40, .right_m = 0.5, .left_m = 0.7, .ahead_m = 0.5}};
  const GuidedPath path = guided_path(sections, {}, SectionRun::kThere);
  const VehicleDescription vehicle = two_wheels();
  SectionLocaliser localiser({}, vehicle, path);
  while (localiser.pose().x < 38.75) localiser.predict(WheelSteps{20, 20});
  const Segment2 wall{{40.5, -0.5}, {40.5, 0.7}};
  for (int i = 0; i < 3; ++i) localiser.correct(std::vector{seen_from({39, 0, 0}, wall)}, 0);
  EXPECT_NEAR(localiser.pose().x, 39, 0.05);
}

TEST(SectionLocaliser, TheEndOfTheBaseLineCorrectsTheLongitudinalPosition) {
  const Segment2 last{{4, -0.5}, kRight.end};
  EXPECT_NEAR(believed({last}, {.length_by_line_end = true}).x(), 4, 0.03);
  EXPECT_NEAR(believed({last}).x(), 3.9, 0.02);
}

TEST(SectionLocaliser, AWallAheadWithARecessTurnsItLittle) {
  const GuidedPath path = guided_path(kSections, {}, SectionRun::kThere);
  const VehicleDescription vehicle = two_wheels();
  SectionLocaliser localiser({}, vehicle, path);
  const auto see = [&](const std::vector<Segment2>& walls) {
    std::vector<SensedSegment> edges;
    for (const Segment2& wall : walls) edges.push_back(seen_from({}, wall));
    localiser.correct(edges, 0);
  };
  for (int i = 0; i < 60; ++i) see({kRight, kLeft});
  for (int i = 0; i < 20; ++i) {
    localiser.predict(WheelSteps{22, 22});
    see({{{2, -1}, {2.2, 1}}});  // 6 degrees
  }
  EXPECT_LT(std::abs(localiser.pose().theta), 3 * kDegree);
}

/// Out to a wall ahead, with wheels that count too little, and home again with the same wheels.
TEST(SectionLocaliser, ComesHomeWithTheOdometryScaleOfThePathOut) {
  constexpr double kOff_m = 0.04, kCounted = 0.99, kTurn_m = 4.5;
  const GuidedPath path = guided_path(kSections, {}, SectionRun::kThere);
  const VehicleDescription vehicle = two_wheels();
  const double step_m = 20 * vehicle.differential.step_length_m();
  SectionLocaliser localiser({}, vehicle, path);
  double x_m = kOff_m;
  for (; x_m < kTurn_m; x_m += step_m / kCounted) localiser.predict(WheelSteps{20, 20});
  for (int i = 0; i < 20; ++i) localiser.correct(std::vector{seen_from({x_m, 0, 0}, kEndWall)}, 0);
  EXPECT_NEAR(localiser.pose().x, x_m, 0.02);
  for (; x_m > kOff_m; x_m -= step_m / kCounted) localiser.predict(WheelSteps{-20, -20});
  EXPECT_NEAR(localiser.pose().x - localiser.start_pose().x, x_m - kOff_m, 0.01);
}

TEST(SectionLocaliser, LaterImagesCorrectTheStartHeading) {
  const GuidedPath path = guided_path(kSections, {}, SectionRun::kThere);
  SectionLocaliser localiser({}, two_wheels(), path);
  constexpr double kSetDown_rad = 4 * kDegree;
  for (int i = 0; i < 10; ++i) localiser.predict(WheelSteps{22, 22});
  std::vector<SensedSegment> edges;
  for (const Segment2& wall : {kRight, kLeft}) edges.push_back(seen_from({0.3, 0.02, kSetDown_rad}, wall));
  EXPECT_EQ(localiser.start_pose().theta, 0);
  for (int i = 0; i < 20; ++i) localiser.correct(edges, 0);
  EXPECT_NEAR(localiser.start_pose().theta / kDegree, kSetDown_rad / kDegree, 1);
}

TEST(SectionLocaliser, IgnoresWallsFarFromTheirExpectedPlace) {
  const Segment2 other{{4.7, -0.5}, {4.7, 0.7}};
  EXPECT_NEAR(believed({other}).x(), 3.9, 0.02);
}

}  // namespace
}  // namespace aisle
