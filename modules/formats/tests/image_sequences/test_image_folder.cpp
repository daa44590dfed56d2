#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "image_sequences/recordings.hpp"
#include "natural_order.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ImageFolder : public testing::Test {
 protected:
  void SetUp() override {
    for (const int i : {1, 2, 9, 10})
      write_file(folder / ("frame_" + std::to_string(i) + ".jpg"), sample_jpeg(i));
  }

  std::unique_ptr<ImageSequence> open(const ImageSequenceOptions& options = {}) {
    auto sequence = open_image_sequence(folder.string(), options);
    EXPECT_TRUE(sequence.ok()) << to_string(sequence.problems());
    return std::move(sequence).value();
  }

  std::unique_ptr<ImageSequence> open_list(const std::string& text,
                                           const ImageSequenceOptions& options = {}) {
    write_file(folder / "list.csv", text);
    return open(options);
  }

  std::string refusal_of_list(const std::string& text) {
    write_file(folder / "list.csv", text);
    const auto sequence = open_image_sequence(folder.string());
    return sequence.ok() ? "" : to_string(sequence.problems());
  }

  SessionPlace place;
  std::filesystem::path folder = place / "images";
};

TEST(NaturalOrder, CountsDigits) {
  EXPECT_TRUE(is_before_naturally("frame_9", "frame_10"));
  EXPECT_FALSE(is_before_naturally("frame_10", "frame_9"));
  EXPECT_TRUE(is_before_naturally("a", "a1"));
  EXPECT_TRUE(is_before_naturally("a01b", "a1b"));
  EXPECT_FALSE(is_before_naturally("a1b", "a01b"));
  EXPECT_FALSE(is_before_naturally("x", "x"));
}

TEST_F(ImageFolder, WithoutAListNeedsARate) {
  const auto refused = open_image_sequence(folder.string());
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(to_string(refused.problems()), HasSubstr("has 4 images without stamps: --image-rate HZ"));
  const auto images = read_all(*open({.rate_hz = 4, .front_steered = {}}));
  ASSERT_THAT(images, SizeIs(4));
  EXPECT_EQ(images[2].bytes, sample_jpeg(9));
  EXPECT_EQ(images[3].bytes, sample_jpeg(10));
  EXPECT_NEAR(images[3].stamp_s, 0.75, 1e-12);
}

TEST_F(ImageFolder, OtherKindsOfImagesBecomePng) {
  Random random(5);
  const Image image = sample_image(20, 18, 1, random);
  std::string pgm = "P5\n20 18\n255\n";
  pgm.append(image.bytes.begin(), image.bytes.end());
  std::filesystem::remove_all(folder);
  write_file(folder / "one.PGM", pgm);
  const auto images = read_all(*open({.rate_hz = 1, .front_steered = {}}));
  ASSERT_THAT(images, SizeIs(1));
  EXPECT_TRUE(images[0].bytes.starts_with("\x89PNG"));
  EXPECT_EQ(*parse_image(images[0].bytes, "one"), image);
}

TEST_F(ImageFolder, AListTellsOrderAndStamps) {
  const auto sequence =
      open_list("\xEF\xBB\xBFstamp_s,file,note\r\n0.5,frame_10.jpg,x\r\n\r\n1,\"frame_1.jpg\",y\r\n");
  const auto images = read_all(*sequence);
  ASSERT_THAT(images, SizeIs(2));
  EXPECT_EQ(images[0].bytes, sample_jpeg(10));
  EXPECT_EQ(images[1].stamp_s, 1);
  EXPECT_THAT(to_string(sequence->warnings()), HasSubstr("columns that are not read: note"));
}

TEST_F(ImageFolder, PosesAreOdometry) {
  const auto sequence =
      open_list("stamp_s,file,x_m,y_m,heading_deg\n1,frame_1.jpg,1,2,90\n2,frame_2.jpg,1,3,90\n");
  EXPECT_TRUE(sequence->has_odometry());
  EXPECT_THAT(sequence->warnings(), IsEmpty());
  const auto images = read_all(*sequence);
  ASSERT_THAT(images, SizeIs(2));
  EXPECT_THAT(*images[1].T_odom_vehicle, PoseNear(Pose2{1, 3, kPi / 2}, 1e-12, 1e-12));
}

TEST_F(ImageFolder, DistanceAndSteeringNeedAWheelbase) {
  const std::string text = "stamp_s,file,distance_m,steering_deg\n1,frame_1.jpg,5,0\n2,frame_2.jpg,6,90\n";
  EXPECT_THAT(refusal_of_list(text), HasSubstr("--vehicle"));
  const auto images = read_all(*open_list(text, {.rate_hz = {}, .front_steered = FrontSteered{0.5}}));
  ASSERT_THAT(images, SizeIs(2));
  EXPECT_THAT(*images[1].T_odom_vehicle, PoseNear(Pose2{0, 0, 2}, 1e-9, 1e-9));  // turns on the spot: 1 / 0.5
}

TEST_F(ImageFolder, SpeedsAreAveragedBetweenRows) {
  const auto images = read_all(*open_list(
      "stamp_s,file,speed_mps,yaw_rate_dps\n1,frame_1.jpg,1,0\n2,frame_2.jpg,2,0\n4,frame_9.jpg,2,0\n"));
  ASSERT_THAT(images, SizeIs(3));
  EXPECT_THAT(*images[1].T_odom_vehicle, PoseNear(Pose2{1.5, 0, 0}, 1e-12, 1e-12));
  EXPECT_THAT(*images[2].T_odom_vehicle, PoseNear(Pose2{5.5, 0, 0}, 1e-12, 1e-12));
}

TEST_F(ImageFolder, BadRowsAreLeftOutWithOneWarning) {
  const auto sequence =
      open_list("stamp_s,file\n1,frame_1.jpg\nsoon,frame_2.jpg\n3\n4,frame_9.jpg\nnan,frame_10.jpg\n");
  EXPECT_THAT(read_all(*sequence), SizeIs(2));
  EXPECT_EQ(sequence->left_out(), 3U);
  EXPECT_THAT(
      to_string(sequence->warnings()),
      HasSubstr("list.csv:3: stamp_s: 'soon' is no number from 0 to 2.14748e+09; 3 records are left out"));
}

TEST_F(ImageFolder, HeadersThatCannotBeMeantAreRefused) {
  EXPECT_THAT(refusal_of_list("time,name\n1,a.jpg\n"), HasSubstr("has no column 'file'"));
  EXPECT_THAT(refusal_of_list("file\na.jpg\n"), HasSubstr("has no column 'stamp_s'; --image-rate HZ"));
  EXPECT_THAT(refusal_of_list("stamp_s,file,x_m,y_m\n1,a.jpg,0,0\n"),
              HasSubstr("has not all of the columns x_m, y_m, heading_deg"));
  EXPECT_THAT(refusal_of_list("stamp_s,file,x_m,y_m,heading_deg,speed_mps,yaw_rate_dps\n"),
              HasSubstr("gives the motion twice"));
  EXPECT_THAT(refusal_of_list("stamp_s,file\n1626922343713,frame_1.jpg\n"), HasSubstr("none of the images"));
}

TEST_F(ImageFolder, SeveralListsAreRefused) {
  write_file(folder / "a.csv", "stamp_s,file\n");
  write_file(folder / "b.csv", "stamp_s,file\n");
  const auto refused = open_image_sequence(folder.string());
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(to_string(refused.problems()), HasSubstr("has 2 lists"));
}

TEST_F(ImageFolder, WhatIsNoRecordingIsRefused) {
  write_file(place / "empty/readme.txt", "x");
  write_file(place / "bag/drive.bag", "x");
  for (const auto& [name, why] :
       std::vector<std::pair<std::string, std::string>>{{"nowhere", "no such file"},
                                                        {"empty", "is no recording"},
                                                        {"empty/readme.txt", "is no recording"},
                                                        {"bag", "is not a bag"}}) {
    const auto refused = open_image_sequence((place / name).string());
    ASSERT_FALSE(refused.ok()) << name;
    EXPECT_THAT(to_string(refused.problems()), HasSubstr(why)) << name;
  }
}

}  // namespace
}  // namespace aisle
