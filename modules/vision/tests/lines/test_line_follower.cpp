#include <gmock/gmock.h>

#include <cmath>

#include "aisle/vision/lines/line_follower.hpp"

namespace aisle {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Ge;

/// Stripes of these tones, the first from the left edge, each later one from its column on.
struct Stripes {
  std::vector<int> columns_px;
  std::vector<int> tones;

  Image image() const {
    Image grey(400, 300);
    for (int v = 0; v < grey.height_px; ++v) {
      for (int u = 0; u < grey.width_px; ++u) {
        std::size_t stripe = 0;
        while (stripe < columns_px.size() && u >= columns_px[stripe]) ++stripe;
        grey.row(v)[u] = static_cast<std::uint8_t>(tones[stripe]);
      }
    }
    return grey;
  }

  std::vector<VerticalLine> lines() const {
    std::vector<VerticalLine> lines;
    for (std::size_t i = 0; i < columns_px.size(); ++i) {
      const double u = columns_px[i] - 0.5;
      lines.push_back({.top_px = {u, 50}, .bottom_px = {u, 250}, .contrast = 1.0 * tones[i + 1] - tones[i]});
    }
    return lines;
  }
};

std::vector<int> follow(LineFollower& follower, const Stripes& scene) {
  return follower.follow(scene.image(), scene.lines());
}

const Stripes kCorridor = {{80, 120, 170, 230, 300}, {200, 60, 180, 90, 150, 40}};

TEST(LineFollower, AStandingCameraSeesTheSameLines) {
  LineFollower follower;
  EXPECT_THAT(follow(follower, kCorridor), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(follow(follower, kCorridor), ElementsAre(0, 1, 2, 3, 4));
}

TEST(LineFollower, ALineThatComesOnGetsANewNumberAndOneThatWentLeavesItsOwnUnused) {
  LineFollower follower;
  follow(follower, kCorridor);
  const Stripes changed = {{120, 170, 195, 210, 230, 300}, {60, 180, 90, 250, 90, 150, 40}};
  EXPECT_THAT(follow(follower, changed), ElementsAre(1, 2, 5, 6, 3, 4));
}

TEST(LineFollower, LinesOnSideWallsAreFollowedWhileTheCameraDrivesOn) {
  LineFollower follower;
  follow(follower, kCorridor);
  const auto nearer = [](int column_px) {  // as a wall's points move while the camera drives on
    const double x = (column_px - 200) / 400.0;
    return static_cast<int>(std::lround(200 + 400 * x / (1 - 1.2 * std::abs(x))));
  };
  Stripes ahead = kCorridor;
  for (int& column : ahead.columns_px) column = nearer(column);
  EXPECT_THAT(follow(follower, ahead), ElementsAre(0, 1, 2, 3, 4));
}

TEST(LineFollower, ATurnIsFollowedToo) {
  LineFollower follower;
  follow(follower, kCorridor);
  Stripes turned = kCorridor;
  for (int& column : turned.columns_px) column += 50;
  EXPECT_THAT(follow(follower, turned), ElementsAre(0, 1, 2, 3, 4));
}

TEST(LineFollower, NothingIsFollowedIntoAnotherPlace) {
  LineFollower follower;
  follow(follower, kCorridor);
  const Stripes elsewhere = {{90, 150, 260}, {20, 120, 10, 250}};
  EXPECT_THAT(follow(follower, elsewhere), Each(Ge(5)));
}

TEST(LineFollower, AnEmptyImageIsBridgedByNothing) {
  LineFollower follower;
  follow(follower, kCorridor);
  EXPECT_TRUE(follow(follower, {{}, {100}}).empty());
  EXPECT_THAT(follow(follower, kCorridor), Each(Ge(5)));
}

std::vector<LineLook> looks(const Stripes& scene) {
  return line_looks(scene.image(), scene.lines());
}

TEST(LinesLikeness, IsOneForTheSameLinesAndSymmetric) {
  const auto lines = looks(kCorridor), others = looks({{60, 200, 330}, {90, 180, 60, 200}});
  EXPECT_DOUBLE_EQ(lines_likeness(lines, lines, {}), 1);
  EXPECT_DOUBLE_EQ(lines_likeness(lines, others, {}), lines_likeness(others, lines, {}));
}

TEST(LinesLikeness, FromNearerTheSameLinesAreMoreAlikeThanOthers) {
  // 0.25 of the width from the middle goes to 0.25 / (1 - 1.2 x 0.25).
  const Stripes nearer = {{13, 95, 167, 233, 343}, kCorridor.tones};
  const Stripes elsewhere = {{80, 120, 170, 230, 300}, {60, 200, 90, 180, 40, 150}};
  EXPECT_GT(lines_likeness(looks(kCorridor), looks(nearer), {}), 0.8);
  EXPECT_LT(lines_likeness(looks(kCorridor), looks(elsewhere), {}), 0.6);
}

TEST(LinesLikeness, WithoutLinesNothingSpeaksAgainst) {
  EXPECT_DOUBLE_EQ(lines_likeness({}, {}, {}), 1);
  EXPECT_LT(lines_likeness(looks(kCorridor), {}, {}), 0.5);
}

}  // namespace
}  // namespace aisle
