#include <gmock/gmock.h>

#include <cmath>

#include "aisle/formats/json_document.hpp"
#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/sessions/session_origin.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

TEST(JsonDocument, ADocumentIsReadWithItsOrder) {
  const auto json = parse_json<nlohmann::ordered_json>(R"({"b": "[[\"[", "a": [1]})", "file");
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->begin().key(), "b");
}

TEST(JsonDocument, WhatIsMalformedIsNamedByItsLine) {
  EXPECT_THAT(to_string(parse_json("{\n\"a\" 1}", "file").problems()),
              HasSubstr("file:2: is not well-formed"));
}

TEST(JsonDocument, LevelsAndBytesHaveLimits) {
  EXPECT_TRUE(parse_json(nested(64), "file").ok());
  EXPECT_THAT(to_string(parse_json("\n" + nested(65), "file").problems()),
              HasSubstr("file:2: nests deeper than 64 levels"));
  EXPECT_THAT(to_string(parse_json(std::string(17 << 20, ' '), "file").problems()), HasSubstr("16 MiB"));
}

/// Printing such a version, or copying such a decision, would overflow the stack.
TEST(JsonDocument, SessionsThatNestDeeplyAreRefused) {
  const std::string deep = nested(200'000);
  EXPECT_THAT(
      to_string(
          parse_session_origin(R"({"format": "aisle.session", "version": )" + deep + "}", "s").problems()),
      HasSubstr("nests deeper"));
  EXPECT_FALSE(parse_decision(R"({"command": )" + deep + "}").has_value());
  EXPECT_FALSE(parse_operator(R"({"marks": )" + deep + "}").has_value());
}

TEST(JsonDocument, SeedsThatAreNoWholeNumberAreRefused) {
  for (const char* seed : {"-1e308", "1e308", "-1", "0.5", "18446744073709551616", "\"1\""}) {
    const std::string text = std::string(R"({"format": "aisle.session", "version": 1, "navigator": "hand",
                                         "parameters": {}, "simulated": true, "seed": )") +
                             seed + "}";
    EXPECT_THAT(to_string(parse_session_origin(text, "s").problems()),
                HasSubstr("seed: is not a whole number"))
        << seed;
  }
}

}  // namespace
}  // namespace aisle
