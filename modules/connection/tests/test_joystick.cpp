#include <gmock/gmock.h>

#include <cmath>

#include "joystick.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kPlace = 0, kEnd = 1, kDeadMan = 4;

ros::Joy pushed(float ahead, float left, const std::vector<int>& pressed) {
  ros::Joy message;
  message.axes = {left, ahead};
  message.buttons.resize(5);
  for (const int button : pressed) message.buttons[static_cast<std::size_t>(button)] = 1;
  return message;
}

TEST(JoystickTest, NothingIsAskedForBeforeItSaysSomething) {
  Joystick joystick{ConnectedJoystick{}};
  EXPECT_FALSE(joystick.input(0).requested);
}

TEST(JoystickTest, MovesOnlyWhileTheDeadManButtonIsHeld) {
  Joystick joystick{ConnectedJoystick{}};
  ASSERT_TRUE(joystick.take(pushed(1, -0.5F, {kDeadMan}), 10));
  const auto asked = joystick.input(10.1).requested;
  EXPECT_NEAR(asked->speed_mps, 0.3, 1e-9);
  EXPECT_NEAR(asked->turn_rate_rad_s, -15 * kDegree, 1e-6);
  EXPECT_LT(asked->steering_rad, 0);
  ASSERT_TRUE(joystick.take(pushed(1, 0, {}), 10.2));
  EXPECT_EQ(joystick.input(10.2).requested->speed_mps, 0);
}

TEST(JoystickTest, SilenceStops) {
  Joystick joystick{ConnectedJoystick{}};
  ASSERT_TRUE(joystick.take(pushed(1, 0, {kDeadMan}), 10));
  EXPECT_GT(joystick.input(10 + 0.9 * Joystick::kSilentMax_s).requested->speed_mps, 0);
  EXPECT_EQ(joystick.input(10 + 1.1 * Joystick::kSilentMax_s).requested->speed_mps, 0);
}

TEST(JoystickTest, AButtonMarksOnceHoweverLongItIsHeld) {
  Joystick joystick{ConnectedJoystick{}};
  ASSERT_TRUE(joystick.take(pushed(0, 0, {kPlace}), 1));
  ASSERT_TRUE(joystick.take(pushed(0, 0, {kPlace}), 1.1));
  EXPECT_THAT(joystick.input(1.1).marks, ElementsAre(Mark{Mark::Kind::kPlace, "place 1"}));
  EXPECT_THAT(joystick.input(1.2).marks, IsEmpty());
  ASSERT_TRUE(joystick.take(pushed(0, 0, {}), 1.3));
  ASSERT_TRUE(joystick.take(pushed(0, 0, {kPlace}), 1.4));
  EXPECT_THAT(joystick.input(1.4).marks, ElementsAre(Mark{Mark::Kind::kPlace, "place 2"}));
}

TEST(JoystickTest, TheEndButtonEndsTheRoute) {
  Joystick joystick{ConnectedJoystick{}};
  ASSERT_TRUE(joystick.take(pushed(0, 0, {kEnd}), 1));
  const OperatorInput input = joystick.input(1);
  EXPECT_TRUE(input.quit);
  EXPECT_THAT(input.marks, ElementsAre(Mark{Mark::Kind::kStop, {}}));
}

TEST(JoystickTest, WhatLacksAxesOrIsNoNumberIsNotTaken) {
  Joystick joystick{ConnectedJoystick{}};
  EXPECT_FALSE(joystick.take(ros::Joy{}, 1));
  EXPECT_FALSE(joystick.take(pushed(NAN, 0, {kDeadMan}), 1));
  ros::Joy few = pushed(1, 0, {kDeadMan});
  few.buttons.resize(4);
  EXPECT_FALSE(joystick.take(few, 1));
  EXPECT_FALSE(joystick.input(1).requested);
}

}  // namespace
}  // namespace aisle
