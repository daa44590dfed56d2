#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "aisle/formats/images/image_file.hpp"
#include "aisle/vision/floor/base_lines.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

/// Labelled by hand in the data: the wall-floor edge, near and far [px].
struct Labelled {
  const char* image;
  bool right;
  Vec2 far_px, near_px;

  friend void PrintTo(const Labelled& labelled, std::ostream* out) { *out << labelled.image; }
};

double distance_px(const BaseLine& line, const Vec2& p) {
  const Vec2 along = (line.back() - line.front()).normalized();
  return std::abs(left_normal(along).dot(p - line.front()));
}

class RealBaseLines : public testing::TestWithParam<Labelled> {};

TEST_P(RealBaseLines, LieWithinFourPixelsOfTheLabelsOfTheFloor) {
  const auto file = real_data() / "images" / "hedau_layout" / GetParam().image;
  AISLE_NEEDS(file);
  const Image grey = to_grey(read_image(file).value());
  const auto verticals = VerticalLineDetector().detect(grey);
  const BaseLines lines = BaseLineDetector().detect(grey, verticals);
  const auto& line = GetParam().right ? lines.right : lines.left;
  ASSERT_TRUE(line);
  for (const double share : {0.3, 0.6, 1.0}) {
    const Vec2 p = GetParam().far_px + share * (GetParam().near_px - GetParam().far_px);
    EXPECT_LT(distance_px(*line, p), 4);
  }
}

/// A right base line marked by hand: its visible points, from far to near.
struct MarkedLine {
  std::string image;  ///< relative to the images of the data
  std::vector<Vec2> points_px;

  /// Mean distance of points spread evenly along it from a line.
  double off_px(const BaseLine& line) const {
    constexpr int kPointsPerPiece = 20;
    double sum = 0, length_px = 0;
    for (std::size_t i = 1; i < points_px.size(); ++i) {
      const Vec2 piece = points_px[i] - points_px[i - 1];
      for (int k = 0; k < kPointsPerPiece; ++k) {
        const double share = (k + 0.5) / kPointsPerPiece;
        sum += piece.norm() / kPointsPerPiece * distance_px(line, points_px[i - 1] + share * piece);
      }
      length_px += piece.norm();
    }
    return sum / length_px;
  }
};

std::vector<MarkedLine> marked_lines() {
  std::ifstream file(std::filesystem::path(AISLE_SOURCE_DIR) / "tests" / "data" / "right_base_lines.txt");
  std::vector<MarkedLine> lines;
  for (std::string text; std::getline(file, text);) {
    std::istringstream words(text);
    MarkedLine& line = lines.emplace_back();
    words >> line.image;
    for (double u = 0, v = 0; words >> u >> v;) line.points_px.emplace_back(u, v);
  }
  return lines;
}

TEST(RealImages, RightBaseLinesAreNearThoseMarkedByHand) {
  AISLE_NEEDS(real_data() / "images" / "office_corridor_walkable");
  const auto marked = marked_lines();
  std::vector<double> offs_px;
  for (const MarkedLine& line : marked) {
    const Image grey = to_grey(read_image(real_data() / "images" / line.image).value());
    const auto found = BaseLineDetector().detect(grey, VerticalLineDetector().detect(grey)).right;
    if (found) offs_px.push_back(line.off_px(*found) * 640 / grey.width_px);
  }
  ASSERT_FALSE(offs_px.empty());
  std::sort(offs_px.begin(), offs_px.end());
  double mean_px = 0;
  for (const double off_px : offs_px) mean_px += off_px / static_cast<double>(offs_px.size());
  fmt::print(
      "right base lines: {} of {} found, off by {:.2f} px of 640 (mean), {:.2f} (median), {:.1f} (9 in 10)\n",
      offs_px.size(), marked.size(), mean_px, offs_px[offs_px.size() / 2], offs_px[offs_px.size() * 9 / 10]);
  EXPECT_GE(offs_px.size(), marked.size() * 8 / 10);
  EXPECT_LE(mean_px, 2);
}

INSTANTIATE_TEST_SUITE_P(Labels, RealBaseLines,
                         testing::Values(Labelled{"corridor/p1010067_c.jpg", true, {145, 121}, {207, 242}},
                                         Labelled{"corridor/pasillo.jpg", false, {113, 99}, {2, 254}}));

}  // namespace
}  // namespace aisle
