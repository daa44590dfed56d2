#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/vehicle/odometry_track.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

/// Two metres ahead in a second, then a metre to the left in two.
const std::vector<OdometrySample> kSamples = {{10, {0, 0, 0}}, {11, {2, 0, 0}}, {13, {2, 1, kPi / 2}}};

TEST(OdometryTrack, IsInterpolatedBetweenSamples) {
  const OdometryTrack track(kSamples);
  EXPECT_THAT(track.at(10.25, 3), PoseNear(Pose2{0.5, 0, 0}, 1e-12, 1e-12));
  EXPECT_THAT(track.at(11, 3), PoseNear(Pose2{2, 0, 0}, 1e-12, 1e-12));
  EXPECT_THAT(track.at(12, 3), PoseNear(Pose2{2, 0.5, kPi / 4}, 1e-12, 1e-12));
}

TEST(OdometryTrack, TheVehicleStandsBeforeTheFirstSample) {
  EXPECT_THAT(OdometryTrack(kSamples).at(9, 3), PoseNear(kSamples[0].T_odom_vehicle, 0, 0));
}

TEST(OdometryTrack, TheLastMotionIsCarriedOnForHalfASecond) {
  const OdometryTrack track(kSamples);
  EXPECT_THAT(track.at(13.2, 3), PoseNear(Pose2{2, 1.1, 0.55 * kPi}, 1e-12, 1e-12));
  EXPECT_THAT(track.at(13.5, 3), PoseNear(Pose2{2, 1.25, 0.625 * kPi}, 1e-12, 1e-12));
  EXPECT_THAT(track.at(99, 3), PoseNear(track.at(13.5, 3), 0, 0));
}

TEST(OdometryTrack, OnlyTheKnownSamplesCount) {
  const OdometryTrack track(kSamples);
  EXPECT_THAT(track.at(11.25, 2), PoseNear(Pose2{2.5, 0, 0}, 1e-12, 1e-12));
  EXPECT_THAT(track.at(12, 1), PoseNear(kSamples[0].T_odom_vehicle, 0, 0));
}

RC_GTEST_PROP(OdometryTrack, LaterSamplesDoNotChangeWhatWasKnown, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<OdometrySample> samples;
  double time_s = 0;
  for (int i = 0; i < 12; ++i) {
    time_s += random.uniform() < 0.2 ? 0 : random.uniform(0, 0.3);
    samples.push_back({time_s, {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)}});
  }
  const std::size_t known = 1 + random.index(samples.size());
  const std::vector<OdometrySample> prefix(samples.begin(),
                                           samples.begin() + static_cast<std::ptrdiff_t>(known));
  const double at_s = random.uniform(-1, time_s + 1);
  const Pose2 from_all = OdometryTrack(samples).at(at_s, known),
              from_prefix = OdometryTrack(prefix).at(at_s, 999);
  RC_ASSERT(from_all.x == from_prefix.x && from_all.y == from_prefix.y &&
            from_all.theta == from_prefix.theta);
}

TEST(OdometryTrack, OfTwoSamplesAtOneTimeTheLaterCounts) {
  const std::vector<OdometrySample> samples = {
      {10, {0, 0, 0}}, {11, {1, 0, 0}}, {11, {2, 0, 0}}, {12, {4, 0, 0}}};
  const OdometryTrack track(samples);
  EXPECT_THAT(track.at(11, 4), PoseNear(Pose2{2, 0, 0}, 0, 0));
  EXPECT_THAT(track.at(11.5, 4), PoseNear(Pose2{3, 0, 0}, 1e-12, 0));
}

TEST(OdometryTrack, AMotionBetweenStampsThatAlmostAgreeIsNotCarriedOn) {
  const std::vector<OdometrySample> samples = {{10, {0, 0, 0}}, {10.5, {1, 0, 0}}, {10.50001, {1.01, 0, 0}}};
  EXPECT_THAT(OdometryTrack(samples).at(10.6, 3), PoseNear(Pose2{1.21, 0, 0}, 1e-2, 1e-12));
  const std::vector<OdometrySample> together = {{10, {0, 0, 0}}, {10.00001, {1, 0, 0}}};
  EXPECT_THAT(OdometryTrack(together).at(10.6, 2), PoseNear(Pose2{1, 0, 0}, 0, 0));
}

}  // namespace
}  // namespace aisle
