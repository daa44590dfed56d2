#include <gmock/gmock.h>

#include "ros/cdr.hpp"
#include "ros/messages.hpp"

namespace robots {
namespace {

using testing::ElementsAre;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text.push_back(static_cast<char>(value));
  return text;
}

/// 1.0 is 3f f0 00 .. 00, least byte first; numbers are aligned from after the encapsulation.
const std::string kTwistStamped = bytes({0, 1, 0, 0,                       // encapsulation
                                         5, 0, 0, 0, 9,   0, 0,    0,      // stamp
                                         2, 0, 0, 0, 'a', 0,               // frame_id with its end
                                         0, 0,                             // up to a multiple of eight
                                         0, 0, 0, 0, 0,   0, 0xf0, 0x3f})  // linear.x
                                  + std::string(5 * 8, '\0');

TEST(Cdr, WritesAStampedTwistAsTheStandardSays) {
  TwistStamped message;
  message.header = {{5, 9}, "a"};
  message.twist.linear.x = 1;
  EXPECT_EQ(to_cdr(message), kTwistStamped);
}

TEST(Cdr, ReadsAStampedTwist) {
  const auto message = from_cdr<TwistStamped>(kTwistStamped);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->header.stamp.sec, 5);
  EXPECT_EQ(message->header.stamp.nanosec, 9u);
  EXPECT_EQ(message->header.frame_id, "a");
  EXPECT_EQ(message->twist.linear.x, 1);
  EXPECT_EQ(message->twist.angular.z, 0);
}

/// A sequence without items has no padding after its count.
const std::string kJoints = bytes({0, 1, 0, 0,                                             // encapsulation
                                   0, 0, 0, 0, 0, 0, 0, 0, 1,   0,   0, 0,    0, 0, 0, 0,  // header
                                   1, 0, 0, 0, 3, 0, 0, 0, 'l', 'w', 0, 0,                 // one name
                                   1, 0, 0, 0, 0, 0, 0, 0, 0,   0,   0, 0x40,              // one position: 2
                                   0, 0, 0, 0, 0, 0, 0, 0});  // no velocity, no effort

TEST(Cdr, WritesAndReadsSequences) {
  JointState message;
  message.name = {"lw"};
  message.position = {2};
  EXPECT_EQ(to_cdr(message), kJoints);
  const auto read = from_cdr<JointState>(kJoints);
  ASSERT_TRUE(read);
  EXPECT_THAT(read->name, ElementsAre("lw"));
  EXPECT_THAT(read->position, ElementsAre(2));
}

template <CdrMessage Message>
void expect_refused_when_cut_short(const std::string& whole) {
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(from_cdr<Message>(whole.substr(0, size))) << size << " bytes";
  }
}

TEST(Cdr, RefusesEveryMessageThatIsCutShort) {
  expect_refused_when_cut_short<TwistStamped>(kTwistStamped);
  expect_refused_when_cut_short<JointState>(kJoints);
}

TEST(Cdr, RefusesOtherEncapsulationsAndCountsThatCannotBe) {
  std::string big_endian = kTwistStamped;
  big_endian[1] = 0;
  EXPECT_FALSE(from_cdr<TwistStamped>(big_endian));
  std::string many_joints = kJoints;
  many_joints[23] = 0x7f;
  EXPECT_FALSE(from_cdr<JointState>(many_joints));
}

}  // namespace
}  // namespace robots
