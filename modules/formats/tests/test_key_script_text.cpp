#include <gmock/gmock.h>

#include "aisle/formats/key_script_text.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::string problems_of(const std::string& text) {
  const auto keys = parse_key_script(text, "keys.txt");
  return keys.ok() ? "" : to_string(keys.problems());
}

TEST(KeyScriptText, KeysAreReadWithTheirTimesAndLabels) {
  const auto keys =
      parse_key_script("# out\n0-3.5 up\n\n4 turning 7\n5 place lobby west\n6 quit\n", "keys.txt");
  ASSERT_TRUE(keys.ok()) << to_string(keys.problems());
  ASSERT_THAT(*keys, SizeIs(4));
  EXPECT_EQ((*keys)[0].key.kind, Key::Kind::kUp);
  EXPECT_EQ((*keys)[0].to_s, 3.5);
  EXPECT_EQ((*keys)[1].key.mark, (Mark{Mark::Kind::kTurningBegins, "7"}));
  EXPECT_EQ((*keys)[1].from_s, 4);
  EXPECT_EQ((*keys)[2].key.mark, (Mark{Mark::Kind::kPlace, "lobby west"}));
}

TEST(KeyScriptText, EveryProblemIsNamedWithItsLine) {
  EXPECT_EQ(problems_of("x up\n3-1 up\n1 jump\n1 turning 14\n1 place\n1 up now\n1-nan up\n"),
            "keys.txt:1: 'x' is not a time FROM or FROM-TO in seconds\n"
            "keys.txt:2: '3-1' is not a time FROM or FROM-TO in seconds\n"
            "keys.txt:3: 'jump' is none of up, down, left, right, stop, quit, turning, turning-ends, place, "
            "route-ends\n"
            "keys.txt:4: a turning is a number from 1 to 13\n"
            "keys.txt:5: a place needs a name of at most 64 characters\n"
            "keys.txt:6: 'now' is unexpected\n"
            "keys.txt:7: '1-nan' is not a time FROM or FROM-TO in seconds");
  EXPECT_THAT(problems_of(""), HasSubstr("keys.txt: has no keys"));
}

}  // namespace
}  // namespace aisle
