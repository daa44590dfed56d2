#include "aisle/vision/lines/vertical_lines.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "drawn_corridor.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::vector<VerticalLine> lines_of(const Image& grey) {
  return VerticalLineDetector().detect(grey);
}

double u_at(const VerticalLine& line, double v_px) {
  const Vec2 down = line.bottom_px - line.top_px;
  return line.top_px.x() + down.x() / down.y() * (v_px - line.top_px.y());
}

/// Dark to the left of a line, bright to its right, between two rows; grey above and beneath.
Image step_image(int width_px, int height_px, const Vec2& top_px, const Vec2& bottom_px) {
  return drawn(width_px, height_px, 8, [&](const Vec2& p) {
    if (p.y() < top_px.y() || p.y() > bottom_px.y()) return 110.0;
    const double share = (p.y() - top_px.y()) / (bottom_px.y() - top_px.y());
    return p.x() < top_px.x() + share * (bottom_px.x() - top_px.x()) ? 60.0 : 160.0;
  });
}

TEST(VerticalLines, AStepIsFoundToATwentiethOfAPixelWhereverInAPixelItIs) {
  for (const double part_px : {0.0, 0.1, 0.25, 0.4, 0.5, 0.75, 0.9}) {
    const double u_px = 100 + part_px;
    const auto lines = lines_of(step_image(320, 240, {u_px, 48}, {u_px, 200}));
    ASSERT_THAT(lines, SizeIs(1)) << part_px;
    EXPECT_NEAR(lines[0].top_px.x(), u_px, 0.05);
    EXPECT_NEAR(lines[0].bottom_px.x(), u_px, 0.05);
    EXPECT_NEAR(lines[0].top_px.y(), 48, 1.5);
    EXPECT_NEAR(lines[0].bottom_px.y(), 200, 1.5);
    EXPECT_NEAR(lines[0].contrast, 100, 2);
  }
}

TEST(VerticalLines, ALeaningLineIsFoundAllAlongToATenthOfAPixel) {
  const Vec2 top_px(200.3, 60), bottom_px(217.8, 400);
  const auto lines = lines_of(step_image(640, 480, top_px, bottom_px));
  ASSERT_THAT(lines, SizeIs(1));
  for (const double share : {0.05, 0.5, 0.95}) {
    const Vec2 p = top_px + share * (bottom_px - top_px);
    EXPECT_NEAR(u_at(lines[0], p.y()), p.x(), 0.1);
  }
}

TEST(VerticalLines, InAWideImageTheyAreInItsOwnPixels) {
  const auto lines = lines_of(step_image(1000, 750, {400.4, 100}, {400.4, 600}));
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_NEAR(u_at(lines[0], 350), 400.4, 0.15);
  EXPECT_NEAR(lines[0].top_px.y(), 100, 6);
  EXPECT_NEAR(lines[0].bottom_px.y(), 600, 6);
}

TEST(VerticalLines, TheSignOfTheContrastTellsTheBrighterSide) {
  const Image bright_right = step_image(320, 240, {100, 48}, {100, 200});
  EXPECT_GT(lines_of(bright_right).at(0).contrast, 0);
  EXPECT_LT(lines_of(mirrored(bright_right)).at(0).contrast, 0);
}

TEST(VerticalLines, AnInterruptedLineIsOneLine) {
  Image image = step_image(640, 480, {300.5, 80}, {300.5, 420});
  for (int v = 200; v < 230; ++v) std::fill(image.row(v) + 280, image.row(v) + 320, std::uint8_t{110});
  const auto lines = lines_of(image);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_NEAR(lines[0].bottom_px.y() - lines[0].top_px.y(), 340, 6);
}

TEST(VerticalLines, ADiagonalIsNone) {
  EXPECT_THAT(lines_of(step_image(640, 480, {200, 60}, {400, 420})), IsEmpty());
}

TEST(VerticalLines, ATiltedAndRolledCameraSeesTheDoorsOfACorridor) {
  DrawnCorridor corridor;
  corridor.down_rad = 8 * kDegree;
  corridor.roll_rad = 5 * kDegree;
  const auto lines = lines_of(corridor.image());
  for (const double z_m : {3.0, 3.9, 5.6}) {
    const Vec2 middle_px = corridor.pixel({0.9, 0, z_m});
    const bool found = std::any_of(lines.begin(), lines.end(), [&](const VerticalLine& line) {
      return std::abs(u_at(line, middle_px.y()) - middle_px.x()) < 0.7;
    });
    EXPECT_TRUE(found) << "door edge at " << z_m << " m";
  }
}

TEST(VerticalLines, AKnownLensIsUndone) {
  DrawnCorridor corridor;
  corridor.camera = {260, 260, 159.5, 119.5, -0.25};
  corridor.width_px = 320;
  corridor.height_px = 240;
  const Image image = corridor.image();
  VerticalLineDetector detector({}, CameraModel(corridor.camera));
  const auto& lines = detector.detect(image);
  const Vec2 middle_px = corridor.pixel({0.9, 0.2, 3.0}), low_px = corridor.pixel({0.9, 0.9, 3.0});
  const auto line = std::find_if(lines.begin(), lines.end(), [&](const VerticalLine& candidate) {
    return (candidate.bottom_px - low_px).norm() < 6;
  });
  ASSERT_NE(line, lines.end());
  EXPECT_NEAR(line->bottom_px.x(), low_px.x(), 1);
  EXPECT_NEAR(u_at(*line, middle_px.y()), middle_px.x(), 4) << "the chord of an arc";
}

TEST(VerticalLines, FlatNoisyAndTinyImagesHaveNone) {
  EXPECT_THAT(lines_of(Image()), IsEmpty());
  EXPECT_THAT(lines_of(Image(640, 480)), IsEmpty());
  for (const int size : {1, 2, 7, 17}) EXPECT_THAT(lines_of(Image(size, size)), IsEmpty());
  EXPECT_THAT(lines_of(Image(640, 1)), IsEmpty());
  EXPECT_THAT(lines_of(Image(1, 480)), IsEmpty());
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    Image noise(640, 480);
    for (auto& byte : noise.bytes) byte = static_cast<std::uint8_t>(random.index(256));
    EXPECT_THAT(lines_of(noise), IsEmpty());
    for (auto& byte : noise.bytes) byte = static_cast<std::uint8_t>(std::lround(128 + random.normal(6)));
    EXPECT_THAT(lines_of(noise), IsEmpty());
  }
}

TEST(VerticalLines, AnImageMustHaveOneChannel) {
  EXPECT_THROW(lines_of(Image(64, 64, 3)), std::invalid_argument);
}

TEST(VerticalLines, ADetectorGivesTheSameAfterOtherImages) {
  const Image image = DrawnCorridor().image(2);
  VerticalLineDetector detector;
  const auto first = detector.detect(image);
  detector.detect(Image(100, 900));
  detector.detect(mirrored(image));
  const auto& again = detector.detect(image);
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(again[i].top_px, first[i].top_px);
}

/// Bars of random place, width and brightness on a grey ground.
Image random_bars(Random& random) {
  Image image(320, 240);
  std::fill(image.bytes.begin(), image.bytes.end(), std::uint8_t{120});
  for (int u = 20; u < 290; u += 20 + static_cast<int>(random.index(20))) {
    const auto level =
        static_cast<std::uint8_t>(random.index(2) == 0 ? random.uniform(60, 95) : random.uniform(145, 180));
    const int width_px = 7 + static_cast<int>(random.index(10));
    const int top = static_cast<int>(random.index(80)), bottom = 140 + static_cast<int>(random.index(100));
    for (int v = top; v < bottom; ++v) std::fill(image.row(v) + u, image.row(v) + u + width_px, level);
  }
  return image;
}

RC_GTEST_PROP(VerticalLines, MirroringTheImageMirrorsThem, (std::uint64_t seed)) {
  Random random(seed);
  const Image image = random_bars(random);
  const auto lines = lines_of(image);
  auto turned = lines_of(mirrored(image));
  std::reverse(turned.begin(), turned.end());
  RC_ASSERT(!lines.empty() && lines.size() == turned.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    RC_ASSERT(std::abs(319 - lines[i].bottom_px.x() - turned[i].bottom_px.x()) < 1e-3);
    RC_ASSERT(std::abs(lines[i].contrast + turned[i].contrast) < 1e-3);
  }
}

RC_GTEST_PROP(VerticalLines, BrightnessAndContrastOfTheImageDoNotMoveThem, (std::uint64_t seed)) {
  Random random(seed);
  const Image image = random_bars(random);
  Image other = image;
  const double gain = random.uniform(0.8, 1.3), offset = random.uniform(-20, 10);
  for (auto& byte : other.bytes) byte = static_cast<std::uint8_t>(std::lround(gain * byte + offset));
  const auto lines = lines_of(image), others = lines_of(other);
  RC_ASSERT(lines.size() == others.size());
  for (std::size_t i = 0; i < lines.size(); ++i) RC_ASSERT((lines[i].top_px - others[i].top_px).norm() < 0.1);
}

}  // namespace
}  // namespace aisle
