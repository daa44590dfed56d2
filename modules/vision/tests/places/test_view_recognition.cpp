#include "aisle/vision/places/view_recognition.hpp"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace aisle {
namespace {

TEST(ViewRecognition, TheMostAlikeViewHasItsRivalElsewhere) {
  const std::array unlike = {0.5, 0.15, 0.125, 0.14, 0.375}, along = {0.0, 1.0, 2.0, 3.0, 4.0};
  const auto found = recognise_view(unlike, along, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->view, 2U);
  EXPECT_EQ(found->unlike, 0.125);
  EXPECT_EQ(found->rival_unlike, 0.375);
  EXPECT_TRUE(found->is_sure(0.125, 3));
  EXPECT_FALSE(found->is_sure(0.125, 3.1)) << "elsewhere it looks nearly so";
  EXPECT_FALSE(found->is_sure(0.12, 3)) << "it does not look so here";
}

TEST(ViewRecognition, OnePlaceAloneHasNoRival) {
  const std::array unlike = {0.2, 0.1}, along = {0.0, 0.1};
  const auto found = recognise_view(unlike, along, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rival_unlike, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(found->is_sure(0.1, 100));
}

TEST(ViewRecognition, OfNoViewsNoneIsRecognised) {
  EXPECT_FALSE(recognise_view({}, {}, 1));
}

TEST(ViewRecognition, ThreeImagesThatGoOnAlongThePathConfirmEachOther) {
  const std::array<std::size_t, 9> views = {4, 5, 7, 1, 6, 6, 6, 12, 13};
  EXPECT_THAT(confirmed_in_succession(views, 3),
              testing::ElementsAre(true, true, true, false, false, false, false, false, false))
      << "6, 6, 6 goes nowhere, and 12 is too far ahead";
  EXPECT_THAT(confirmed_in_succession(std::array<std::size_t, 2>{1, 2}, 3),
              testing::ElementsAre(false, false));
}

}  // namespace
}  // namespace aisle
