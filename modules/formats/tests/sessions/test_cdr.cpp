#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <limits>

#include "aisle/core/random.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text.push_back(static_cast<char>(value));
  return text;
}

ros::JointState sample_joints() {
  return {{{1, 2}, "a"}, {"left", "r"}, {1.5, -0.0}, {}, {std::numeric_limits<double>::denorm_min()}};
}

TEST(Cdr, AStringIsItsLengthWithTheFinalZeroAndItsBytes) {
  EXPECT_EQ(cdr_bytes(ros::String{"hi"}), bytes({0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0}));
}

TEST(Cdr, NumbersAreAlignedToTheirSizeAfterTheEncapsulationAndGapsAreZero) {
  ros::PoseStamped message;
  message.header = {{1, 2}, "m"};
  message.pose.position.x = 1;
  const std::string cdr = cdr_bytes(message);
  // seconds, nanoseconds, length 2, 'm', 0, and two bytes of padding up to the next multiple of eight
  EXPECT_EQ(cdr.substr(0, 20), bytes({0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 'm', 0, 0, 0}));
  EXPECT_EQ(cdr.substr(20, 8), bytes({0, 0, 0, 0, 0, 0, 0xF0, 0x3F}));
  EXPECT_EQ(cdr.size(), 20U + 7 * 8);
}

TEST(Cdr, BigEndianMessagesAreRead) {
  const auto message = parse_cdr<ros::String>(bytes({0, 0, 0, 0, 0, 0, 0, 3, 'h', 'i', 0}));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->data, "hi");
}

TEST(Cdr, PaddingAfterTheLastFieldDoesNotMatter) {
  EXPECT_EQ(parse_cdr<ros::String>(cdr_bytes(ros::String{"hi"}) + std::string(1, '\0')), ros::String{"hi"});
}

TEST(Cdr, MessagesComeBackBitForBit) {
  const auto back = parse_cdr<ros::JointState>(cdr_bytes(sample_joints()));
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, sample_joints());
  EXPECT_TRUE(std::signbit(back->position[1]));
}

RC_GTEST_PROP(CdrProperty, EveryDoubleComesBackBitForBit, ()) {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  ros::Twist message;
  message.angular.z = value;
  const auto back = parse_cdr<ros::Twist>(cdr_bytes(message));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(back->angular.z) == std::bit_cast<std::uint64_t>(value));
}

TEST(Cdr, EveryCutIsNoticed) {
  const std::string whole = cdr_bytes(sample_joints());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_cdr<ros::JointState>(whole.substr(0, length))) << length;
}

TEST(Cdr, LengthsBeyondTheAvailableBytesAreRefused) {
  const std::string huge = bytes({0, 1, 0, 0, 0xFF, 0xFF, 0xFF, 0x7F});
  EXPECT_FALSE(parse_cdr<ros::TFMessage>(huge));
  EXPECT_FALSE(parse_cdr<ros::String>(huge));
}

RC_GTEST_PROP(CdrProperty, AnyBytesAreReadOrRefused, (const std::string& tail)) {
  const std::string message = bytes({0, 1, 0, 0}) + tail;
  (void)parse_cdr<ros::Image>(message);
  (void)parse_cdr<ros::JointState>(message);
  (void)parse_cdr<ros::TFMessage>(message);
  (void)parse_cdr<ros::LaserScan>(message);
}

RC_GTEST_PROP(RosTimeProperty, AStampIsKeptToTheNanosecondAndThenForGood, ()) {
  const double stamp_s =
      static_cast<double>(*rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 53)) * 0x1p-22;
  const double kept_s = ros::stamp_s(ros::stamp_ns(stamp_s));
  RC_ASSERT(std::abs(kept_s - stamp_s) <= 0.6e-9 + stamp_s * 0x1p-52);  // half a nanosecond and the rounding
  RC_ASSERT(ros::stamp_s(ros::stamp_ns(kept_s)) == kept_s);
  RC_ASSERT(ros::stamp_ns(ros::time_of(ros::stamp_ns(stamp_s))) == ros::stamp_ns(stamp_s));
}

TEST(RosTime, RefusesStampsThatDoNotFitInAMessage) {
  EXPECT_THROW((void)ros::stamp_ns(-1e-9), std::invalid_argument);
  EXPECT_THROW((void)ros::stamp_ns(2147483648.0), std::invalid_argument);
  EXPECT_THROW((void)ros::stamp_ns(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
