#include "aisle/vision/floor/base_lines.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/vision/floor/line_finder.hpp"
#include "drawn_corridor.hpp"

namespace aisle {
namespace {

/// Greatest distance of points from a polyline.
double distance_px(const std::vector<Vec2>& points, const BaseLine& line) {
  double greatest = 0;
  for (const Vec2& p : points) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 along = line[i] - line[i - 1];
      const double share = std::clamp(along.dot(p - line[i - 1]) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - line[i - 1] - share * along).norm());
    }
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

FoundLines look_at(const Image& grey, const std::optional<CameraModel>& camera = std::nullopt) {
  return LineFinder({}, camera).find(grey);
}

void expect_base_lines(const DrawnCorridor& corridor, const BaseLines& lines, double tolerance_px) {
  ASSERT_TRUE(lines.left && lines.right);
  EXPECT_LT(distance_px(corridor.base_line(corridor.left_m), *lines.left), tolerance_px);
  EXPECT_LT(distance_px(corridor.base_line(corridor.right_m), *lines.right), tolerance_px);
}

TEST(BaseLines, AreTheLowerEdgesOfTheSkirtingBoardsOfACorridor) {
  const DrawnCorridor corridor;
  const auto lines = look_at(corridor.image()).base_lines;
  expect_base_lines(corridor, lines, 1.5);
  ASSERT_TRUE(lines.vanishing_point_px);
  EXPECT_LT((*lines.vanishing_point_px - Vec2(319.5, 239.5)).norm(), 5);
}

TEST(BaseLines, AreFoundWithoutSkirtingBoards) {
  DrawnCorridor corridor;
  corridor.skirting_m = 0;
  expect_base_lines(corridor, look_at(corridor.image()).base_lines, 1.5);
}

TEST(BaseLines, OfLowSkirtingBoardsAreAsSharp) {
  for (const double skirting_m : {0.03, 0.05, 0.07}) {
    DrawnCorridor corridor;
    corridor.skirting_m = skirting_m;
    expect_base_lines(corridor, look_at(corridor.image()).base_lines, 1);
  }
}

TEST(BaseLines, AreFoundByATiltedAndRolledCamera) {
  DrawnCorridor corridor;
  corridor.down_rad = 6 * kDegree;
  corridor.roll_rad = 4 * kDegree;
  expect_base_lines(corridor, look_at(corridor.image()).base_lines, 2);
}

TEST(BaseLines, AreNotTakenForTheirReflectionsInAShinyFloor) {
  DrawnCorridor corridor;
  corridor.shine = 0.3;
  expect_base_lines(corridor, look_at(corridor.image()).base_lines, 2);
}

TEST(BaseLines, OfAMirroredImageAreMirrored) {
  const Image image = DrawnCorridor().image();
  const auto lines = look_at(image).base_lines, turned = look_at(mirrored(image)).base_lines;
  ASSERT_TRUE(lines.left && lines.right && turned.left && turned.right);
  const auto expect_mirrored = [](const BaseLine& a, const BaseLine& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((Vec2(639 - a[i].x(), a[i].y()) - b[i]).norm(), 1);
  };
  expect_mirrored(*lines.left, *turned.right);
  expect_mirrored(*lines.right, *turned.left);
}

TEST(BaseLines, DoNotMoveWithTheBrightnessOfTheImage) {
  const DrawnCorridor corridor;
  Image image = corridor.image();
  for (auto& byte : image.bytes) byte = static_cast<std::uint8_t>(0.7 * byte + 20);
  expect_base_lines(corridor, look_at(image).base_lines, 1.5);
}

TEST(BaseLines, BendWithAKnownLens) {
  DrawnCorridor corridor;
  corridor.camera = {260, 260, 159.5, 119.5, -0.2};
  corridor.width_px = 320;
  corridor.height_px = 240;
  const auto lines = look_at(corridor.image(), CameraModel(corridor.camera)).base_lines;
  expect_base_lines(corridor, lines, 1.5);
  EXPECT_GT(lines.right->size(), 2U);
}

TEST(BaseLines, DoorFramesStandOnThemAndTheirReflectionsDoNotCount) {
  for (const double shine : {0.0, 0.3}) {
    DrawnCorridor corridor;
    corridor.shine = shine;
    const auto verticals = look_at(corridor.image()).verticals;
    for (const double z_m : {3.0, 3.9, 5.6}) {
      const Vec2 floor_point_px = corridor.pixel({corridor.right_m, corridor.height_m, z_m});
      const bool stands = std::any_of(verticals.begin(), verticals.end(), [&](const VerticalLine& line) {
        return line.has_floor_point && (line.bottom_px - floor_point_px).norm() < 2;
      });
      EXPECT_TRUE(stands) << "door edge at " << z_m << " m, shine " << shine;
    }
  }
}

TEST(BaseLines, FlatNoisyAndTinyImagesHaveNone) {
  const auto expect_none = [](const Image& image) {
    const auto lines = look_at(image).base_lines;
    EXPECT_FALSE(lines.left || lines.right);
  };
  expect_none(Image());
  expect_none(Image(640, 480));
  expect_none(Image(3, 200));
  expect_none(Image(40, 33));
  Random random(1);
  Image noise(640, 480);
  for (auto& byte : noise.bytes) byte = static_cast<std::uint8_t>(random.index(256));
  expect_none(noise);
  for (auto& byte : noise.bytes) byte = static_cast<std::uint8_t>(std::lround(128 + random.normal(6)));
  expect_none(noise);
}

TEST(BaseLines, AnImageMustHaveOneChannel) {
  EXPECT_THROW(BaseLineDetector().detect(Image(64, 64, 3), {}), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
