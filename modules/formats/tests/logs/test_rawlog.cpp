#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/formats/logs/rawlog.hpp"
#include "logs/mrpt_bytes.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

LaserRecording rawlog(const std::string& bytes, const RecordingOptions& options = {}) {
  auto recording = parse_rawlog(bytes, "run.rawlog", options);
  if (!recording.ok()) throw std::runtime_error(to_string(recording.problems()));
  return *recording;
}

std::string rawlog_problems(const std::string& bytes) {
  const auto recording = parse_rawlog(bytes, "run.rawlog");
  return recording.ok() ? "" : to_string(recording.problems());
}

TEST(Rawlog, ObservationsAreScansAndPosesByTheirOwnStamps) {
  MrptScanBytes scan;
  scan.pose = mrpt_pose3({0.5, 0.1, 0.2});
  const LaserRecording recording = rawlog(mrpt_odometry({1, 2, 0.5}, 999.5) + mrpt_scan(scan));
  ASSERT_THAT(recording.log.scans, SizeIs(1));
  EXPECT_THAT(recording.log.scans[0].ranges_m, ElementsAre(1, 2, 3));
  EXPECT_NEAR(recording.log.scans[0].stamp_s, 1000, 1e-6);
  EXPECT_EQ(recording.log.scans[0].odometry_known, 1U);
  EXPECT_EQ(recording.log.scans[0].line, 2);
  EXPECT_NEAR(recording.log.laser().first_angle_rad, -1, 1e-6);
  EXPECT_NEAR(recording.log.laser().angle_step_rad, 1, 1e-6);
  EXPECT_NEAR(recording.log.laser().range_max_m, 9.7, 1e-6);
  EXPECT_THAT(recording.log.laser().T_vehicle_laser, PoseNear(Pose2{0.5, 0.1, 0.2}, 1e-9, 1e-9));
  EXPECT_TRUE(recording.has_mounting);
  ASSERT_THAT(recording.log.odometry, SizeIs(1));
  EXPECT_THAT(recording.log.odometry[0].T_odom_vehicle, PoseNear(Pose2{1, 2, 0.5}, 0, 0));
  EXPECT_NEAR(recording.log.odometry[0].time_s, 999.5, 1e-6);
  EXPECT_THAT(recording.warnings, IsEmpty());
}

TEST(Rawlog, MovementsAddUpToThePoseOfTheFrameAfterThem) {
  for (const int version : {6, 7}) {
    MrptScanBytes first, second;
    first.stamp_s = 100;
    second.stamp_s = 101;
    const LaserRecording recording =
        rawlog(mrpt_action({0, 0, kPi / 2}, version) + mrpt_frame(mrpt_scan(first)) +
               mrpt_action({0.5, 0, 0}, version) + mrpt_frame(mrpt_scan(second)));
    ASSERT_THAT(recording.log.odometry, SizeIs(2));
    EXPECT_THAT(recording.log.odometry[1].T_odom_vehicle, PoseNear(Pose2{0, 0.5, kPi / 2}, 1e-9, 1e-9));
    EXPECT_EQ(recording.log.odometry[1].time_s, recording.log.scans[1].time_s);
    EXPECT_EQ(recording.log.scans[1].odometry_known, 2U);
  }
}

TEST(Rawlog, AFrameBeforeTheFirstMovementIsTheOrigin) {
  const LaserRecording recording =
      rawlog(mrpt_frame(mrpt_scan({})) + mrpt_action({0.1, 0, 0}) + mrpt_frame(mrpt_scan({})));
  ASSERT_THAT(recording.log.odometry, SizeIs(2));
  EXPECT_THAT(recording.log.odometry[0].T_odom_vehicle, PoseNear(Pose2{}, 0, 0));
  EXPECT_EQ(recording.log.scans[0].odometry_known, 1U);
  EXPECT_EQ(recording.log.scans[1].odometry_known, 2U);
}

TEST(Rawlog, EveryVersionOfAScanIsRead) {
  for (int version = 0; version <= 7; ++version) {
    MrptScanBytes scan;
    scan.version = version;
    EXPECT_THAT(rawlog(mrpt_scan(scan) + mrpt_scan(scan)).log.scans, SizeIs(2)) << version;
  }
  MrptScanBytes unknown;
  unknown.version = 8;
  EXPECT_THAT(rawlog_problems(mrpt_scan({}) + mrpt_scan(unknown)),
              HasSubstr("run.rawlog:2: object CObservation2DRangeScan of version 8"));
}

TEST(Rawlog, EveryVersionOfASensorPoseIsRead) {
  const auto size = [](std::uint32_t rows) { return mrpt_value(rows) + mrpt_value(rows); };
  std::string floats = size(4), doubles = size(4);
  for (const double value :
       {1.0, 0.0, 0.0, 0.78, 0.0, 1.0, 0.0, 0.1, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 0.0, 1.0}) {
    floats += mrpt_value(static_cast<float>(value));
    doubles += mrpt_value(value);
  }
  std::string quaternion;
  for (const double value : {0.78, 0.1, 0.3, 1.0, 0.0, 0.0, 0.0}) quaternion += mrpt_value(value);
  for (const std::string& pose : {mrpt_object("CPose3D", 0, mrpt_object("CMatrix", 0, floats)),
                                  mrpt_object("CPose3D", 1, mrpt_object("CMatrixD", 0, doubles)),
                                  mrpt_object("CPose3D", 2, quaternion), mrpt_pose3({0.78, 0.1, 0})}) {
    MrptScanBytes scan;
    scan.pose = pose;
    scan.space = "";
    EXPECT_THAT(rawlog(mrpt_scan(scan)).log.laser().T_vehicle_laser,
                PoseNear(Pose2{0.78, 0.1, 0}, 1e-6, 1e-6));
  }
}

TEST(Rawlog, ScansFromLeftToRightAndUpsideDownAreTurned) {
  MrptScanBytes clockwise;
  clockwise.counter_clockwise = false;
  EXPECT_THAT(rawlog(mrpt_scan(clockwise)).log.scans[0].ranges_m, ElementsAre(3, 2, 1));
  MrptScanBytes hanging;
  hanging.pose = mrpt_pose3({}, -1);
  EXPECT_THAT(rawlog(mrpt_scan(hanging)).log.scans[0].ranges_m, ElementsAre(3, 2, 1));
  hanging.counter_clockwise = false;
  EXPECT_THAT(rawlog(mrpt_scan(hanging)).log.scans[0].ranges_m, ElementsAre(1, 2, 3));
}

TEST(Rawlog, ScannersOnTheirSideAreLeftOut) {
  MrptScanBytes upright;
  upright.pose = mrpt_pose3({}, 0);
  const LaserRecording recording = rawlog(mrpt_scan({}) + mrpt_scan(upright));
  EXPECT_THAT(recording.log.scans, SizeIs(1));
  EXPECT_THAT(to_string(recording.warnings), HasSubstr("run.rawlog:2: object: 1 scans are not level"));
}

TEST(Rawlog, EachLabelAtEachPlaceIsAScannerOfItsOwn) {
  MrptScanBytes rear;
  rear.label = "REAR";
  rear.pose = mrpt_pose3({-0.3, 0, kPi - 0.1});
  const LaserRecording recording = rawlog(mrpt_scan({}) + mrpt_scan(rear) + mrpt_scan({}));
  ASSERT_THAT(recording.log.lasers, SizeIs(2));
  EXPECT_EQ(recording.log.scans[1].laser, 1U);
  EXPECT_NEAR(recording.log.lasers[1].T_vehicle_laser.x, -0.3, 1e-9);
  EXPECT_NEAR(recording.log.lasers[1].range_max_m, 9.7, 1e-6);
}

TEST(Rawlog, AnApertureOfHalfADegreeAReadingIsNotBelieved) {
  MrptScanBytes scan;
  scan.aperture_rad = 90 * kDegree;
  scan.readings_m.assign(180, 2);
  scan.valid.assign(180, '\1');
  const LaserRecording recording = rawlog(mrpt_scan(scan));
  EXPECT_NEAR(recording.log.laser().first_angle_rad, -90 * kDegree, 1e-9);
  EXPECT_NEAR(recording.log.laser().angle_step_rad, 1 * kDegree, 1e-9);
  ASSERT_THAT(recording.other_beams, SizeIs(1));
  EXPECT_NEAR(recording.other_beams[0].first_angle_rad, -45 * kDegree, 1e-6);
  EXPECT_THAT(to_string(recording.warnings), HasSubstr("state an aperture of 90 deg"));
}

TEST(Rawlog, ReadingsMarkedInvalidTellNothingUnlessMostAre) {
  MrptScanBytes scan;
  scan.valid = std::string("\1\0\1", 3);
  EXPECT_THAT(rawlog(mrpt_scan(scan)).log.scans[0].ranges_m, ElementsAre(1, 0, 3));
  scan.readings_m = {1, 10, 3};
  EXPECT_THAT(rawlog(mrpt_scan(scan)).log.scans[0].ranges_m, ElementsAre(1, 10, 3));
  scan.valid = std::string("\0\1\0", 3);
  const LaserRecording inverted = rawlog(mrpt_scan(scan));
  EXPECT_THAT(inverted.log.scans[0].ranges_m, ElementsAre(1, 10, 3));
  EXPECT_THAT(to_string(inverted.warnings), HasSubstr("marks are not believed"));
}

TEST(Rawlog, OtherObjectsAreSkippedAndCounted) {
  const std::string gps = mrpt_object("mrpt::obs::CObservationGPS", 10, "whatever\x88 it holds");
  const LaserRecording recording =
      rawlog(gps + mrpt_scan({}) + gps + mrpt_frame(gps + mrpt_scan({}), 2) + gps);
  EXPECT_THAT(recording.log.scans, SizeIs(2));
  EXPECT_THAT(
      to_string(recording.warnings),
      HasSubstr("run.rawlog:1: object: CObservationGPS (version 10) says nothing that is used; 4 such"));
}

TEST(Rawlog, WithoutAUsableScanIsRefused) {
  EXPECT_EQ(rawlog_problems(""), "run.rawlog: is empty");
  EXPECT_THAT(rawlog_problems(mrpt_odometry({}, 1)), HasSubstr("has no usable scans"));
  EXPECT_THAT(rawlog_problems("This is no rawlog."), HasSubstr("no object begins here"));
}

RC_GTEST_PROP(Rawlog, CutAnywhereKeepsTheWholeScans, (std::uint64_t seed)) {
  Random random(seed);
  std::string bytes;
  std::vector<std::size_t> ends;
  for (int i = 0; i < 6; ++i) {
    bytes += mrpt_odometry({0.1 * i, 0, 0}, 100 + i);
    MrptScanBytes scan;
    scan.stamp_s = 100 + i;
    bytes += mrpt_scan(scan);
    ends.push_back(bytes.size());
  }
  const std::size_t cut = random.index(bytes.size() + 1);
  const auto recording = parse_rawlog(std::string_view(bytes).substr(0, cut), "cut");
  const auto whole = static_cast<std::size_t>(
      std::count_if(ends.begin(), ends.end(), [&](std::size_t end) { return end <= cut; }));
  RC_ASSERT(recording.ok() == (whole > 0));
  if (recording.ok()) RC_ASSERT(recording->log.scans.size() == whole);
}

}  // namespace
}  // namespace aisle
