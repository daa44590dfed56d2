#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

#include "aisle/core/random.hpp"
#include "aisle/report/map_picture.hpp"
#include "picture_scale.hpp"
#include "text_count.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Wall wall(const Vec2& start, const Vec2& end, bool is_orthogonal = true) {
  Wall w;
  w.segment = {start, end};
  w.is_orthogonal = is_orthogonal;
  return w;
}

/// 8 m x 4 m with one corner cut off.
WallMap room() {
  return {{wall({0, 0}, {8, 0}), wall({8, 0}, {8, 3}), wall({8, 3}, {7, 4}, false), wall({7, 4}, {0, 4}),
           wall({0, 4}, {0, 0})}};
}

/// Whether every element is closed, in order, and all attributes are quoted.
bool is_well_formed(std::string_view xml) {
  std::vector<std::string_view> open;
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = xml.substr(at + 1, end - at - 1);
    const std::string_view name = tag.substr(tag[0] == '/', tag.find_first_of(" /\n", 1) - (tag[0] == '/'));
    if (count(tag, "\"") % 2 != 0) return false;
    if (tag[0] == '?' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || tag.substr(1) != open.back()) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

/// Big-endian, as in the header of a PNG file.
int number_at(const std::string& png, std::size_t at) {
  int value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(png[i]);
  return value;
}

TEST(MapPicture, TheSvgHasOneLineAWall) {
  const WallMap walls = room();
  const std::string document = svg({.walls = walls, .title = "A room"});
  EXPECT_TRUE(is_well_formed(document));
  const std::string dark = "stroke:rgb(13", orange = "stroke:rgb(78";
  EXPECT_EQ(count(document, orange), 1 + 1);    // and its symbol in the legend
  EXPECT_EQ(count(document, dark), 4 + 1 + 1);  // and its symbol, and the scale bar
}

TEST(MapPicture, ThePngIsSixteenHundredPixelsWide) {
  const WallMap walls = room();
  const std::string file = png({.walls = walls, .title = "A room"});
  EXPECT_THAT(file, StartsWith("\x89PNG\r\n\x1a\n"));
  const PictureScale scale = fit_scale({.walls = walls});
  EXPECT_EQ(number_at(file, 16), scale.width_px);
  EXPECT_EQ(number_at(file, 20), scale.height_px);
}

TEST(MapPicture, SamePictureSameBytes) {
  const WallMap walls = room();
  const std::vector<Pose2> path = {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 1, 0}};
  const std::vector<std::pair<std::size_t, std::size_t>> closures = {{0, 3}};
  const MapPicture picture{walls, path, closures, "A room", "drawn twice", true};
  EXPECT_EQ(svg(picture), svg(picture));
  EXPECT_EQ(png(picture), png(picture));
  EXPECT_TRUE(is_well_formed(svg(picture)));
}

TEST(MapPicture, AnEmptyMapIsAPictureToo) {
  const WallMap nothing;
  EXPECT_TRUE(is_well_formed(svg({.walls = nothing})));
  EXPECT_THAT(png({.walls = nothing}), StartsWith("\x89PNG"));
}

TEST(MapPicture, AStraightPathOfAThousandPosesIsOneLine) {
  const WallMap walls = room();
  std::vector<Pose2> path;
  for (int i = 0; i <= 1000; ++i) path.push_back({1 + 0.005 * i, 2, 0});
  EXPECT_LT(svg({.walls = walls, .path = path}).size(), svg({.walls = walls}).size() + 20'000);
}

TEST(MapPicture, OddTitlesDoNotSpoilThePicture) {
  const WallMap walls = room();
  for (const std::string title : {"\xff\xfe not UTF-8", "two\nlines",
                                  "Stra\xc3\x9f"
                                  "e <&>\"",
                                  ""}) {
    const std::string document = svg({.walls = walls, .title = title});
    EXPECT_TRUE(is_well_formed(document));
    EXPECT_THAT(document, HasSubstr("stroke:rgb(78"));
  }
  EXPECT_TRUE(is_well_formed(svg({.walls = walls, .title = std::string(2000, 'W')})));
}

TEST(PictureScale, RoundLengthsStartWithOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_length(0.7), 0.5);
  EXPECT_DOUBLE_EQ(round_length(1), 1);
  EXPECT_DOUBLE_EQ(round_length(4.9), 2);
  EXPECT_DOUBLE_EQ(round_length(63), 50);
}

RC_GTEST_PROP(PictureScale, EverythingLiesWithinTheMargins, (std::uint64_t seed)) {
  Random random(seed);
  WallMap walls;
  const double side_m = std::pow(10, random.uniform(0, 3));
  for (std::uint64_t i = 0; i < 1 + random.index(5); ++i) {
    walls.walls.push_back(wall({random.uniform(-side_m, side_m), random.uniform()},
                               {random.uniform(), random.uniform(-side_m, side_m)}));
  }
  const PictureScale scale = fit_scale({.walls = walls});
  RC_ASSERT(std::max(scale.width_px, scale.height_px) <= 1600);
  for (const Wall& w : walls.walls) {
    for (const Vec2& p : {scale.to_paper(w.segment.start), scale.to_paper(w.segment.end)}) {
      RC_ASSERT(p.x() >= kMargin_px - 1 && p.x() <= scale.width_px - kMargin_px + 1);
      RC_ASSERT(p.y() >= kHeader_px - 1 && p.y() <= scale.height_px - kFooter_px + 1);
    }
  }
}

}  // namespace
}  // namespace aisle
