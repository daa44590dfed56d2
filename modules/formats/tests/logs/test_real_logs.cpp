#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "pose_matchers.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

TEST(RealLogs, Fr079HasItsScansBeamsAndNoReturnValue) {
  const auto file = real_data() / "laser/fr079/fr079.clf.gz";
  AISLE_NEEDS(file);
  const auto carmen = read_carmen_log(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const LaserLog& log = carmen->log;
  EXPECT_THAT(carmen->warnings, IsEmpty());
  EXPECT_THAT(log.scans, SizeIs(4934));
  EXPECT_THAT(log.odometry, SizeIs(4934));
  EXPECT_THAT(log.scans, Each(Field(&LaserScan::ranges_m, SizeIs(360))));
  EXPECT_NEAR(log.laser().first_angle_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(log.laser().angle_step_rad, kPi / 360, 1e-12);
  EXPECT_GT(log.laser().range_max_m, 60);
  EXPECT_LT(log.laser().range_max_m, 81.91);
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{}, 0, 0));
  EXPECT_FLOAT_EQ(log.scans[0].ranges_m[0], 1.67F);
  EXPECT_DOUBLE_EQ(log.scans[0].stamp_s, 1211.520329);
  EXPECT_DOUBLE_EQ(log.scans.back().time_s, log.scans.back().stamp_s);
}

TEST(RealLogs, AcesHasItsScansBeamsAndNoReturnValue) {
  const auto file = real_data() / "laser/aces/aces.clf.gz";
  AISLE_NEEDS(file);
  const auto carmen = read_carmen_log(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const LaserLog& log = carmen->log;
  EXPECT_THAT(carmen->warnings, IsEmpty());
  EXPECT_THAT(log.scans, SizeIs(7374));
  EXPECT_THAT(log.scans, Each(Field(&LaserScan::ranges_m, SizeIs(180))));
  EXPECT_NEAR(log.laser().angle_step_rad, kDegree, 1e-12);
  EXPECT_NEAR(log.laser().range_max_m, 50, 2);
}

TEST(RealLogs, Fr079RelationsByStampAreThoseByNumber) {
  const auto folder = real_data() / "laser/fr079";
  AISLE_NEEDS(folder);
  const auto carmen = read_carmen_log(folder / "fr079.clf.gz");
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const auto by_stamp = read_relations(folder / "fr079.relations.gz", carmen->log);
  ASSERT_TRUE(by_stamp.ok()) << to_string(by_stamp.problems());
  const auto by_number = read_relations(folder / "fr079.relations-by-index.gz", carmen->log);
  ASSERT_TRUE(by_number.ok()) << to_string(by_number.problems());
  ASSERT_THAT(*by_stamp, SizeIs(1685));
  ASSERT_THAT(*by_number, SizeIs(1685));
  for (std::size_t i = 0; i < by_stamp->size(); ++i) {
    EXPECT_EQ((*by_stamp)[i].scan_1, (*by_number)[i].scan_1);
    EXPECT_EQ((*by_stamp)[i].scan_2, (*by_number)[i].scan_2);
    EXPECT_THAT((*by_stamp)[i].T_1_2, PoseNear((*by_number)[i].T_1_2, 1e-6, 1e-6));
  }
}

}  // namespace
}  // namespace aisle
