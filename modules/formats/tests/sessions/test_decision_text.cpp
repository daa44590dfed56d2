#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "aisle/formats/sessions/decision_text.hpp"

namespace aisle {
namespace {

Decision with_speed(double speed_mps) {
  return {.command = {.speed_mps = speed_mps}, .state = "on"};
}

RC_GTEST_PROP(DecisionTextProperty, EverySpeedThatIsANumberComesBackBitForBit, (std::uint64_t bits)) {
  const double speed_mps = std::bit_cast<double>(bits);
  RC_PRE(!std::isnan(speed_mps));
  const auto back = parse_decision(decision_text(with_speed(speed_mps)));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(back->command.speed_mps) == bits);
}

TEST(DecisionText, DiffersWhereverABitDiffers) {
  EXPECT_NE(decision_text(with_speed(0.0)), decision_text(with_speed(-0.0)));
  EXPECT_NE(decision_text(with_speed(0.1)), decision_text(with_speed(std::nextafter(0.1, 1))));
  Decision done = with_speed(0);
  done.status = NavigatorStatus::kDone;
  EXPECT_NE(decision_text(done), decision_text(with_speed(0)));
}

TEST(DecisionText, NotANumberComesBackAsThat) {
  const auto back = parse_decision(decision_text(with_speed(std::numeric_limits<double>::quiet_NaN())));
  ASSERT_TRUE(back);
  EXPECT_TRUE(std::isnan(back->command.speed_mps));
}

TEST(DecisionText, TextOfOthersIsNoDecision) {
  for (const char* text : {"", "{", "[]", "7", "{\"command\":{}}", "null",
                           R"({"command":{"speed_mps":"fast","steering_rad":0,"turn_rate_rad_s":0},)"
                           R"("status":"going","state":"","why":""})"}) {
    EXPECT_FALSE(parse_decision(text)) << text;
    EXPECT_FALSE(parse_operator(text)) << text;
  }
}

}  // namespace
}  // namespace aisle
