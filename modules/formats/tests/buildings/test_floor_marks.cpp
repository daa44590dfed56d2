#include <gmock/gmock.h>

#include "aisle/formats/buildings/floor_marks.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string mark_problems(const std::string& text) {
  const auto marks = parse_floor_marks(text, "marks.txt");
  return marks.ok() ? "none" : to_string(marks.problems());
}

TEST(FloorMarks, EveryUnreadableLineIsNamed) {
  EXPECT_THAT(mark_problems("1 2 3 4\n1 2 three 4\n\n1 2 3\n1 2 3 4 5\n"),
              AllOf(HasSubstr("marks.txt:2: field 3, x: 'three' is not a number"),
                    HasSubstr("marks.txt:4: the line ends after 3 fields"),
                    HasSubstr("marks.txt:5: more than the four numbers u v x y")));
}

TEST(FloorMarks, FewerThanFourAreRefused) {
  EXPECT_EQ(mark_problems("1 2 3 4\n# 5 6 7 8\n"),
            "marks.txt: has 1 marks; at least 4 are needed, one 'u v x y' a line");
  EXPECT_THAT(mark_problems(""), HasSubstr("has 0 marks"));
}

TEST(FloorMarks, AbsurdNumbersAreRefused) {
  EXPECT_THAT(mark_problems("1 2 3 nan\n"),
              HasSubstr("marks.txt:1: field 4, y: 'nan' is not a usable number"));
  EXPECT_THAT(mark_problems("1e9 2 3 4\n"), HasSubstr("marks.txt:1: field 1, u: '1e9' is absurdly large"));
}

}  // namespace
}  // namespace aisle
