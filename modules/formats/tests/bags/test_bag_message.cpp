#include "aisle/formats/bags/bag_message.hpp"

#include <gmock/gmock.h>

#include "bag_writers.hpp"

namespace aisle {
namespace {

ros::JointState two_joints() {
  return {{{1, 2}, "base"}, {"left", "right wheel"}, {1.5, -2}, {}, {3}};
}

TEST(BagMessage, Ros1IsReadWithoutAlignmentAndWithTheSequence) {
  const std::string bytes = Ros1Bytes::of(two_joints());
  EXPECT_EQ(bytes.substr(0, 4), number_bytes(std::uint32_t{7}));
  EXPECT_EQ(parse_message<ros::JointState>(bytes, BagEncoding::kRos1), two_joints());
  EXPECT_EQ(parse_message<ros::JointState>(cdr_bytes(two_joints()), BagEncoding::kCdr), two_joints());
}

TEST(BagMessage, EveryMessageOfRos1ComesBack) {
  ros::CameraInfo info;
  info.d = {1, 2};
  info.k[8] = 1;
  info.p[11] = 3;
  info.roi.do_rectify = true;
  EXPECT_EQ(parse_message<ros::CameraInfo>(Ros1Bytes::of(info), BagEncoding::kRos1), info);
  ros::CompressedImage image{{{3, 4}, "camera"}, "jpeg", {1, 2, 3}};
  EXPECT_EQ(parse_message<ros::CompressedImage>(Ros1Bytes::of(image), BagEncoding::kRos1), image);
  ros::TFMessage transforms{{{{{1, 2}, "a"}, "b", {}}, {{{3, 4}, "c"}, "d", {}}}};
  EXPECT_EQ(parse_message<ros::TFMessage>(Ros1Bytes::of(transforms), BagEncoding::kRos1), transforms);
  ros::TwistStamped twist;
  twist.twist.angular.z = 2;
  EXPECT_EQ(parse_message<ros::TwistStamped>(Ros1Bytes::of(twist), BagEncoding::kRos1), twist);
  EXPECT_EQ(parse_header(Ros1Bytes::of(image), BagEncoding::kRos1), image.header);
  EXPECT_EQ(parse_header(cdr_bytes(image), BagEncoding::kCdr), image.header);
}

TEST(BagMessage, EveryCutIsNoticedAndLengthsBeyondTheBytesAreRefused) {
  const std::string whole = Ros1Bytes::of(two_joints());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_message<ros::JointState>(whole.substr(0, length), BagEncoding::kRos1)) << length;
  EXPECT_FALSE(parse_message<ros::String>("\xFF\xFF\xFF\x7F", BagEncoding::kRos1));
}

}  // namespace
}  // namespace aisle
