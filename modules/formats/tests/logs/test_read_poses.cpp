#include "aisle/formats/logs/read_poses.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "bags/bag_samples.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadPoses, OfATableWithUnits) {
  const auto poses = parse_pose_csv(
      "# by hand\ntime_ms,x_mm,y_m,heading_deg,note\n500,100,2,90,a\n600,150,2,91,b\n", "t.csv");
  ASSERT_TRUE(poses.ok()) << to_string(poses.problems());
  EXPECT_THAT(poses->stamps_s, ElementsAre(0.5, 0.6));
  EXPECT_NEAR(poses->T_map_vehicle[0].x, 0.1, 1e-12);
  EXPECT_NEAR(poses->T_map_vehicle[0].theta, kPi / 2, 1e-12);
}

TEST(ReadPoses, OfATableNamesLineAndColumn) {
  EXPECT_THAT(to_string(parse_pose_csv("time_s,x_m\n1,2\n", "t.csv").problems()),
              HasSubstr("has only some of the columns x_m, y_m, heading_rad"));
  EXPECT_THAT(to_string(parse_pose_csv("time_s,speed\n1,2\n", "t.csv").problems()),
              HasSubstr("t.csv:1: the header has no columns x_m, y_m"));
  EXPECT_THAT(to_string(parse_pose_csv("time_s,x_m,y_m,heading_rad\n1,2,nan,0\n", "t.csv").problems()),
              HasSubstr("t.csv:2: y_m: 'nan'"));
  EXPECT_THAT(to_string(parse_pose_csv("time_s,x_m,y_m,heading_rad\n1,2\n", "t.csv").problems()),
              HasSubstr("has 2 columns, the header has 4"));
  EXPECT_FALSE(parse_pose_csv("", "t.csv").ok());
}

TEST(ReadPoses, OfAFileByItsContentInTheOrderOfItsStamps) {
  const SessionPlace place;
  write_file(place / "a", "# stamp x y z qx qy qz qw\n2 1 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 5 0 0 0 0 0 1\n");
  write_file(place / "b", "time_s;x_m;y_m;heading_rad\n1;0;0;0\n2;1;0;0\n");
  for (const char* name : {"a", "b"}) {
    const auto poses = read_poses(place / name);
    ASSERT_TRUE(poses.ok()) << name << to_string(poses.problems());
    EXPECT_THAT(poses->stamps_s, ElementsAre(1, 2));
    EXPECT_EQ(poses->T_map_vehicle[1].x, 1) << "of equal stamps, the first";
  }
  EXPECT_THAT(to_string(read_poses(place / "a", "/pose").problems()), HasSubstr("has no topics"));
  write_file(place / "empty", "# nothing\n");
  EXPECT_THAT(to_string(read_poses(place / "empty").problems()), HasSubstr("has no pose"));
  EXPECT_THAT(to_string(read_poses(place / "none").problems()), HasSubstr("no such file"));
}

TEST(ReadPoses, OfABagWithTheStampsOfTheHeaders) {
  const SessionPlace place;
  std::vector<WrittenMessage> messages = Recorded{}.messages();
  write_file(place / "bag.mcap", mcap_bytes(messages));
  const auto poses = read_poses(place / "bag.mcap");
  ASSERT_TRUE(poses.ok()) << to_string(poses.problems());
  ASSERT_EQ(poses->stamps_s.size(), 11U);
  EXPECT_NEAR(poses->stamps_s[1], 100.1, 1e-9) << "recorded at 100.11";
  EXPECT_NEAR(poses->T_map_vehicle[1].x, 0.05, 1e-9);
  messages.push_back(written("/mocap", 100, ros::PoseStamped{}));
  write_file(place / "bag.mcap", mcap_bytes(messages));
  EXPECT_THAT(to_string(read_poses(place / "bag.mcap").problems()),
              HasSubstr("has several topics of poses: name one of them"));
  EXPECT_EQ(read_poses(place / "bag.mcap", "/odom")->stamps_s.size(), 11U);
  EXPECT_THAT(to_string(read_poses(place / "bag.mcap", "/scan").problems()), HasSubstr("has no such poses"));
}

TEST(ReadPoses, SurvivesFlippedBytes) {
  Random random(9);
  const std::string table = "time_s,x_m,y_m,heading_rad\n1,0,0,0\n2,1,0,0\n3,2,0,0\n";
  for (int i = 0; i < 500; ++i) {
    std::string flipped = table;
    for (int flip = 0; flip < 4; ++flip)
      flipped[random.index(flipped.size())] = static_cast<char>(random.bits());
    (void)parse_pose_csv(flipped, "flipped");
  }
}

}  // namespace
}  // namespace aisle
