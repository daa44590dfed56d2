#include <gmock/gmock.h>

#include "aisle/formats/pictures/picture_file.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

/// Labelled by hand in the data: where the floor meets a wall, near and far [px].
struct Labelled {
  const char* picture;
  bool right;
  Vec2 far_px, near_px;

  friend void PrintTo(const Labelled& labelled, std::ostream* out) { *out << labelled.picture; }
};

double distance_px(const BaseLine& line, const Vec2& p) {
  const Vec2 along = (line.back() - line.front()).normalized();
  return std::abs(left_normal(along).dot(p - line.front()));
}

class RealBaseLines : public testing::TestWithParam<Labelled> {};

TEST_P(RealBaseLines, LieWithinFourPixelsOfTheLabelsOfTheFloor) {
  const auto file = real_data() / "images" / "hedau_layout" / GetParam().picture;
  AISLE_NEEDS(file);
  const Image grey = to_grey(read_picture(file).value());
  const auto verticals = VerticalLineDetector().detect(grey);
  const BaseLines lines = BaseLineDetector().detect(grey, verticals);
  const auto& line = GetParam().right ? lines.right : lines.left;
  ASSERT_TRUE(line);
  for (const double share : {0.3, 0.6, 1.0}) {
    const Vec2 p = GetParam().far_px + share * (GetParam().near_px - GetParam().far_px);
    EXPECT_LT(distance_px(*line, p), 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Labels, RealBaseLines,
                         testing::Values(Labelled{"corridor/p1010067_c.jpg", true, {145, 121}, {207, 242}},
                                         Labelled{"corridor/pasillo.jpg", false, {113, 99}, {2, 254}}));

}  // namespace
}  // namespace aisle
