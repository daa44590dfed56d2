#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <string>

#include "field_reader.hpp"

namespace aisle {
namespace {

TEST(FieldReader, ReadsNumbersInEveryUsualForm) {
  EXPECT_EQ(parse_number("12.34"), 12.34);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("7."), 7.0);
  EXPECT_EQ(parse_number("1.5e-3"), 0.0015);
  EXPECT_EQ(parse_number("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_TRUE(std::isinf(parse_number("inf").value()));
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(FieldReader, RefusesWhatIsNoNumberFromEndToEnd) {
  for (const char* text : {"", "-", ".", "-.", "1.2.3", "1x", "x1", "0x10", "--1", "1e", "1,5"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(FieldReader, ReadsDecimalsAsTheStandardLibraryDoes, (std::int64_t digits)) {
  std::string text = std::to_string(digits);
  const auto point = *rc::gen::inRange<std::size_t>(digits < 0 ? 1 : 0, text.size() + 1);
  text.insert(point, ".");
  double expected = 0;
  std::from_chars(text.data(), text.data() + text.size(), expected);
  RC_ASSERT(parse_number(text) == expected);
}

TEST(FieldReader, TheFirstFailureSticks) {
  FieldReader fields("1 two 3");
  EXPECT_EQ(fields.number("a", 10), 1);
  EXPECT_EQ(fields.number("b", 10), 0);
  EXPECT_EQ(fields.number("c", 10), 0);
  EXPECT_EQ(fields.failure(), "field 2, b: 'two' is not a number");
}

TEST(FieldReader, TakesLinesOneByOne) {
  std::string_view text = "a\n\nb";
  EXPECT_EQ(take_line(text), "a");
  EXPECT_EQ(take_line(text), "");
  EXPECT_EQ(take_line(text), "b");
  EXPECT_TRUE(text.empty());
}

}  // namespace
}  // namespace aisle
