#include <gmock/gmock.h>

#include "aisle/formats/sessions/session_origin.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// An origin with these additional members.
std::string origin_with(const std::string& members) {
  return R"({"format":"aisle.session","version":1,"navigator":"hand","parameters":{},"seed":1,"simulated":true)" +
         members + "}";
}

TEST(SessionOrigin, DoesNotMentionABuildingIfThereIsNone) {
  const auto origin = parse_session_origin(origin_with(""), "session");
  ASSERT_TRUE(origin.ok()) << to_string(origin.problems());
  EXPECT_EQ(origin->building, "");
  EXPECT_EQ(origin->route, "");
  EXPECT_FALSE(origin->in_reverse);
  EXPECT_EQ(session_origin_json(*origin), origin_with(""));
}

TEST(SessionOrigin, GivesBackTheBuildingsTextToTheLastByte) {
  SessionOrigin origin{.navigator = "landmarks", .seed = 3};
  origin.building = "{\n\"name\": \"B\xC3\xBCro \\\"1\\\"\"\n}\n";
  origin.route = "desk to door";
  origin.in_reverse = true;
  const auto read = parse_session_origin(session_origin_json(origin), "session");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_EQ(*read, origin);
}

TEST(SessionOrigin, SaysWhatAnImportedSessionLacks) {
  const std::string text = origin_with(R"(,"odometry":false,"calibration":false)");
  const auto origin = parse_session_origin(text, "session");
  ASSERT_TRUE(origin.ok()) << to_string(origin.problems());
  EXPECT_FALSE(origin->has_odometry);
  EXPECT_FALSE(origin->has_calibration);
  EXPECT_EQ(session_origin_json(*origin), text);
}

TEST(SessionOrigin, ValuesOfAnotherKindAreRefused) {
  for (const char* members : {R"(,"building":7)", R"(,"building":null)", R"(,"route":[])",
                              R"(,"in_reverse":"yes")", R"(,"odometry":1)"}) {
    const auto origin = parse_session_origin(origin_with(members), "session");
    ASSERT_FALSE(origin.ok()) << members;
    EXPECT_THAT(to_string(origin.problems()), HasSubstr("does not say what made the session"));
  }
}

}  // namespace
}  // namespace aisle
