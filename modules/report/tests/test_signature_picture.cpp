#include "aisle/report/signature_picture.hpp"

#include <gmock/gmock.h>

#include "text_count.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

TEST(SignaturePicture, ShowsEachWallAndEachMark) {
  SignaturePicture picture{.title = "signatures", .caption = "of one wall"};
  picture.sensed.walls = {{{0, 0}, {4, 0}}};
  picture.sensed.x = {{0, 0, 0.3}, {0, 4, 0.3}};
  picture.sensed.y = {{0, 0, 4}};
  const std::string drawn = svg(picture);
  EXPECT_THAT(drawn, HasSubstr("<svg"));
  constexpr int kWalls = 1, kMarks = 3, kInLegend = 1;
  EXPECT_EQ(count(drawn, "stroke:rgb(13%,47%,86%)"), kWalls + kMarks + kInLegend);
}

TEST(SignaturePicture, AnEmptyPictureIsDrawnToo) {
  EXPECT_THAT(svg(SignaturePicture{}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace aisle
