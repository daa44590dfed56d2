#include <gmock/gmock.h>

#include "aisle/formats/images/plan_image.hpp"
#include "aisle/formats/images/portable_graymap.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string why(const Result<Image>& image) {
  return image.ok() ? "" : to_string(image.problems());
}

TEST(PortableGraymap, PlainAndRawAreRead) {
  const auto plain = parse_pgm("P2\n# a comment\n3 2\n100\n0 50 100\n10 20 30\n", "plan", 10);
  ASSERT_TRUE(plain.ok()) << why(plain);
  EXPECT_THAT(plain->bytes, ElementsAre(0, 128, 255, 26, 51, 77));
  const auto raw = parse_pgm(std::string("P5 2 1 255\n\x00\xcd", 13), "plan", 10);
  ASSERT_TRUE(raw.ok()) << why(raw);
  EXPECT_THAT(raw->bytes, ElementsAre(0, 205));
  const auto wide = parse_pgm(std::string("P5 1 1 65535\n\x80\x00", 15), "plan", 10);
  ASSERT_TRUE(wide.ok()) << why(wide);
  EXPECT_THAT(wide->bytes, ElementsAre(128));
}

TEST(PortableGraymap, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_THAT(why(parse_pgm("P6\n1 1\n255\nabc", "plan", 10)), HasSubstr("does not begin with P2 or P5"));
  EXPECT_THAT(why(parse_pgm("P2\n3 x\n", "plan", 10)),
              HasSubstr("plan:2: height: '' is not a whole number from 1 to 10"));
  EXPECT_THAT(why(parse_pgm("P2\n3 11\n", "plan", 10)), HasSubstr("'11' is not a whole number"));
  EXPECT_THAT(why(parse_pgm("P2\n1 1\n9\n10", "plan", 10)),
              HasSubstr("plan:4: pixel: '10' is not a whole number from 0 to 9"));
  EXPECT_THAT(why(parse_pgm("P5\n3 3\n255\nabc", "plan", 10)), HasSubstr("for 9 pixels"));
  EXPECT_THAT(why(parse_pgm("P5\n1 1\n9\n\x20", "plan", 10)),
              HasSubstr("has a pixel of 32, more than the greatest value 9"));
}

TEST(PlanImage, TheFirstRowIsTheTopAndBlackIsSolid) {
  const auto read = parse_plan_image("P1\n2 2\n1 0\n0 0\n", "plan", 0.1);
  ASSERT_TRUE(read.ok());
  const FloorPlan& plan = read->plan;
  EXPECT_TRUE(plan.is_solid(0, 1));
  EXPECT_FALSE(plan.is_solid(0, 0));
  EXPECT_FALSE(plan.is_solid(1, 1));
  EXPECT_TRUE(plan.is_solid(2, 0)) << "outside";
  EXPECT_NEAR(plan.centre(1, 0).x(), 0.15, 1e-12);
}

TEST(PlanImage, WhatIsUnknownIsSolid) {
  const auto read = parse_plan_image("P2\n3 1\n255\n0 205 254\n", "plan", 0.05);
  ASSERT_TRUE(read.ok());
  const FloorPlan& plan = read->plan;
  EXPECT_TRUE(plan.is_solid(0, 0));
  EXPECT_TRUE(plan.is_solid(1, 0));
  EXPECT_FALSE(plan.is_solid(2, 0));
}

TEST(PlanImage, LightGreyWallsAreSaidAndFoundByAThreshold) {
  const std::string drawn = "P2\n3 1\n255\n255 215 255\n";
  const auto read = parse_plan_image(drawn, "plan", 0.05);
  ASSERT_TRUE(read.ok());
  EXPECT_FALSE(read->plan.is_solid(1, 0));
  EXPECT_THAT(
      to_string(read->warnings),
      HasSubstr("plan: 33.3 % of the pixels have the light grey 215, the first at (1, 0), and count as "
                "free; --threshold 216"));
  const auto darker = parse_plan_image(drawn, "plan", 0.05, (256 - 216) / 255.0);
  EXPECT_TRUE(darker->plan.is_solid(1, 0));
  EXPECT_THAT(darker->warnings, testing::IsEmpty());
}

TEST(PlanImage, TransparentPixelsAreSolidAndSaid) {
  TransparentImage image{Image(2, 1), {0, 1}};
  image.image.bytes = {255, 255};
  const auto read = parse_plan_image(png_bytes(image), "plan", 0.05);
  ASSERT_TRUE(read.ok());
  EXPECT_FALSE(read->plan.is_solid(0, 0));
  EXPECT_TRUE(read->plan.is_solid(1, 0));
  EXPECT_THAT(to_string(read->warnings), HasSubstr("50 % of the pixels are transparent"));
}

TEST(PlanImage, WhatIsNoImageIsAProblem) {
  EXPECT_FALSE(parse_plan_image("hello", "plan", 0.05).ok());
  EXPECT_FALSE(parse_plan_image("", "plan", 0.05).ok());
}

}  // namespace
}  // namespace aisle
