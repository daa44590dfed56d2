#include <gmock/gmock.h>

#include "aisle/guidance/key_controls.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Key::Kind;

Key key(Kind kind) {
  return {.kind = kind};
}

Key mark(Mark::Kind kind, const std::string& label) {
  return {Kind::kMark, {kind, label}};
}

TEST(TerminalKeys, ReadsTheKeysOfThePaper) {
  EXPECT_THAT(TerminalKeys().read("\x1b[A\x1b[B\x1b[D\x1b[Cq "),
              ElementsAre(key(Kind::kUp), key(Kind::kDown), key(Kind::kLeft), key(Kind::kRight),
                          key(Kind::kStop), key(Kind::kQuit)));
}

TEST(TerminalKeys, ReadsSequencesThatArriveInPieces) {
  TerminalKeys keys;
  EXPECT_THAT(keys.read("\x1b"), IsEmpty());
  EXPECT_THAT(keys.read("O"), IsEmpty());
  EXPECT_THAT(keys.read("A"), ElementsAre(key(Kind::kUp)));
}

TEST(TerminalKeys, MarksAreTyped) {
  TerminalKeys keys;
  EXPECT_THAT(keys.read("d13\n"), ElementsAre(mark(Mark::Kind::kTurningBegins, "13")));
  EXPECT_THAT(keys.read("ee"), ElementsAre(mark(Mark::Kind::kTurningEnds, "13")));
  EXPECT_THAT(keys.read("plon"), IsEmpty());
  EXPECT_EQ(keys.typing(), "place: lon");
  EXPECT_THAT(keys.read("\x7f"
                        "bby q\r"),
              ElementsAre(mark(Mark::Kind::kPlace, "lobby q")));
  EXPECT_THAT(keys.read("x"), ElementsAre(mark(Mark::Kind::kStop, "")));
}

TEST(TerminalKeys, AnInvalidTurningIsNoMark) {
  EXPECT_THAT(TerminalKeys().read("d14\nd0\nd\nda7\x1b[A"), ElementsAre(key(Kind::kUp)));
  EXPECT_THAT(TerminalKeys().read("plobby\x1b[A\n"), ElementsAre(key(Kind::kUp)));
}

TEST(KeyControls, UpAndDownDriveStraight) {
  KeyControls controls({.speed_mps = 0.3, .reverse_speed_mps = 0.2}, false);
  EXPECT_EQ(controls.press(1, {key(Kind::kUp)}).requested, (Command{.speed_mps = 0.3}));
  EXPECT_EQ(controls.press(2, {key(Kind::kDown)}).requested, (Command{.speed_mps = -0.2}));
  EXPECT_FALSE(controls.press(3, {}).requested);
}

TEST(KeyControls, LeftKeepsTheSpeedOfAnUpThatIsStillHeld) {
  KeyControls controls({.speed_mps = 0.3, .steering_rad = 0.4}, false);
  controls.press(1, {key(Kind::kUp)});
  EXPECT_EQ(controls.press(1.4, {key(Kind::kLeft)}).requested,
            (Command{.speed_mps = 0.3, .steering_rad = 0.4}));
  EXPECT_EQ(controls.press(1.8, {key(Kind::kRight)}).requested,
            (Command{.speed_mps = 0.3, .steering_rad = -0.4}));
  EXPECT_EQ(controls.press(2.5, {key(Kind::kLeft)}).requested,
            (Command{.speed_mps = 0, .steering_rad = 0.4}));
}

TEST(KeyControls, ADifferentialVehicleTurnsOnTheSpot) {
  KeyControls controls({.turn_rate_rad_s = 0.5}, true);
  EXPECT_EQ(controls.press(1, {key(Kind::kRight)}).requested, (Command{.turn_rate_rad_s = -0.5}));
}

TEST(KeyControls, StopStandsAndMarksAndQuitArePassedOn) {
  KeyControls controls({}, false);
  controls.press(1, {key(Kind::kUp)});
  const OperatorInput input =
      controls.press(1.1, {mark(Mark::Kind::kPlace, "lobby"), key(Kind::kStop), key(Kind::kQuit)});
  EXPECT_EQ(input.requested, Command{});
  EXPECT_TRUE(input.quit);
  EXPECT_THAT(input.marks, ElementsAre(Mark{Mark::Kind::kPlace, "lobby"}));
  EXPECT_EQ(controls.press(1.2, {key(Kind::kLeft)}).requested->speed_mps, 0);
}

}  // namespace
}  // namespace aisle
