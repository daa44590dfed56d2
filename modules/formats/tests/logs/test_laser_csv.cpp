#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/formats/logs/laser_csv.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kFacts = "# first_angle_deg: -90\n# angle_step_deg: 90\n";
const std::string kHeader = "time_s,x_m,y_m,heading_deg,range_0_m,range_1_m,range_2_m\n";

LaserRecording table(const std::string& text, const RecordingOptions& options = {}) {
  auto recording = parse_laser_csv(text, "run.csv", options);
  if (!recording.ok()) throw std::runtime_error(to_string(recording.problems()));
  return *recording;
}

std::string table_problems(const std::string& text) {
  const auto recording = parse_laser_csv(text, "run.csv");
  return recording.ok() ? "" : to_string(recording.problems());
}

TEST(LaserCsv, ARowIsAScanWithItsPose) {
  const LaserRecording recording = table(kFacts + "# range_max_m: 12\n# mount_x_m: 0.2\n" + kHeader +
                                         "10,1,2,90,1.5,2,3\n10.5,1.1,2,90,1,1,1\n");
  EXPECT_THAT(recording.warnings, IsEmpty());
  ASSERT_THAT(recording.log.scans, SizeIs(2));
  EXPECT_THAT(recording.log.scans[0].ranges_m, ElementsAre(1.5F, 2, 3));
  EXPECT_EQ(recording.log.scans[1].time_s, 10.5);
  EXPECT_EQ(recording.log.scans[1].line, 7);
  EXPECT_THAT(recording.log.odometry.at(0).T_odom_vehicle, PoseNear(Pose2{1, 2, kPi / 2}, 1e-12, 1e-12));
  EXPECT_NEAR(recording.log.laser().first_angle_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(recording.log.laser().range_max_m, 12, 0.5);
  EXPECT_THAT(recording.log.laser().T_vehicle_laser, PoseNear(Pose2{0.2, 0, 0}, 0, 0));
  EXPECT_TRUE(recording.has_mounting);
}

TEST(LaserCsv, ColumnsMayHaveOtherUnitsSeparatorsAndOrder) {
  const LaserRecording recording =
      table("range_1_mm;range_0_cm;angle_step_rad;first_angle_rad;time_ms\r\n2000;150;1;-0.5;10000\r\n");
  EXPECT_THAT(recording.log.scans.at(0).ranges_m, ElementsAre(1.5F, 2));
  EXPECT_EQ(recording.log.scans[0].stamp_s, 10);
  EXPECT_NEAR(recording.log.laser().first_angle_rad, -0.5, 1e-12);
  EXPECT_THAT(to_string(recording.warnings), HasSubstr("has no odometry"));
}

TEST(LaserCsv, TheIndexThatPandasWritesDoesNoHarm) {
  const LaserRecording recording = table(kFacts + "," + kHeader + "0,10,1,2,90,1.5,,inf\n");
  EXPECT_EQ(recording.log.scans.at(0).ranges_m[1], 0);
  EXPECT_GE(recording.log.scans[0].ranges_m[2], recording.log.laser().range_max_m);
}

TEST(LaserCsv, RowsWithoutReadingsAreOdometryAlone) {
  const LaserRecording recording = table(kFacts + kHeader + "10,1,2,90,,,\n10.1,1,2,90,1,2,3\n");
  EXPECT_THAT(recording.log.scans, SizeIs(1));
  EXPECT_THAT(recording.log.odometry, SizeIs(2));
  EXPECT_EQ(recording.log.scans[0].odometry_known, 2U);
}

TEST(LaserCsv, ClockwiseBeamsAreTurned) {
  const LaserRecording recording =
      table("# first_angle_deg: 90\n# angle_step_deg: -90\n" + kHeader + "10,1,2,90,1,2,3\n");
  EXPECT_THAT(recording.log.scans.at(0).ranges_m, ElementsAre(3, 2, 1));
  EXPECT_NEAR(recording.log.laser().first_angle_rad, -kPi / 2, 1e-12);
}

TEST(LaserCsv, ColumnsThatMeanNothingAreSaid) {
  const LaserRecording recording = table(kFacts + "battery," + kHeader + "12.1,10,1,2,90,1,2,3\n");
  EXPECT_THAT(to_string(recording.warnings),
              HasSubstr("1 columns mean nothing here and are skipped: battery"));
}

TEST(LaserCsv, ProblemsHaveTheirLineAndColumn) {
  const std::string row = kFacts + kHeader + "10,1,2,90,1,2,3\n";
  EXPECT_THAT(table_problems(row + "11,1,two,90,1,2,3\n"),
              HasSubstr("run.csv:5: y_m: 'two' is not a number"));
  EXPECT_THAT(table_problems(row + "11,1,,90,1,2,3\n"), HasSubstr("run.csv:5: y_m: '' is empty"));
  EXPECT_THAT(table_problems(row + "11,1,2,90,1,x,3\n"),
              HasSubstr("run.csv:5: range_1_m: 'x' is not a number"));
  EXPECT_THAT(table_problems(row + "11,1,2\n"), HasSubstr("run.csv:5: has 3 columns, the header has 7"));
  EXPECT_THAT(table_problems(row + "nan,1,2,90,1,2,3\n"), HasSubstr("run.csv:5: time_s"));
}

TEST(LaserCsv, FactsThatCannotBeUsedAreProblems) {
  const std::string table = kFacts + kHeader + "10,1,2,90,1,2,3\n";
  EXPECT_THAT(table_problems("# range_max_m: twelve\n" + table),
              HasSubstr("run.csv:1: 'twelve' is no usable"));
  EXPECT_THAT(table_problems("# range_max_m: 1e300\n" + table), HasSubstr("run.csv:1: '1e300' is no usable"));
  EXPECT_THAT(table_problems("# range_max: 12\n" + table), HasSubstr("run.csv:1: 'range_max' has no unit"));
  EXPECT_EQ(table_problems("# recorded: today\n" + table), "");
}

TEST(LaserCsv, HeadersThatLackSomethingAreRefusedWithWhatIsMissing) {
  EXPECT_THAT(table_problems("x_m,y_m\n1,2\n"), HasSubstr("run.csv:1: the header has no column 'time_s'"));
  EXPECT_THAT(table_problems("time_s,x_m,range_0_m,range_1_m\n"), HasSubstr("needs all three"));
  EXPECT_THAT(table_problems("time_s\n"), HasSubstr("has no columns 'range_0_m'"));
  EXPECT_THAT(table_problems("time_s,range_0_m,range_2_m\n"), HasSubstr("has no column 'range_1_m'"));
  EXPECT_THAT(table_problems("time_s,time_ms,range_0_m,range_1_m\n"), HasSubstr("has 'time_ms' twice"));
  EXPECT_THAT(table_problems("time_s,range_0_m,range_1_m\n1,2,3\n"),
              HasSubstr("does not say where the beams look"));
  EXPECT_THAT(table_problems(kFacts + kHeader), HasSubstr("has no row with readings"));
}

RC_GTEST_PROP(LaserCsv, CutAnywhereKeepsTheWholeRows, (std::uint64_t seed)) {
  Random random(seed);
  std::string text = kFacts + kHeader;
  const std::size_t head = text.size();
  for (int i = 0; i < 6; ++i) text += std::to_string(10 + i) + ",0.5,0.25,10,1.25,2.25,3.25\n";
  const std::string cut = text.substr(0, head + random.index(text.size() - head + 1));
  const auto whole =
      static_cast<std::size_t>(std::count(cut.begin() + static_cast<long>(head), cut.end(), '\n'));
  const auto recording = parse_laser_csv(cut, "cut");
  RC_ASSERT(whole == 0 || recording.ok());
  if (recording.ok())
    RC_ASSERT(recording->log.scans.size() >= whole && recording->log.scans.size() <= whole + 1);
}

}  // namespace
}  // namespace aisle
