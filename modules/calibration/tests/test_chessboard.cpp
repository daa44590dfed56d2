#include "aisle/calibration/chessboard.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// The image of a board under a homography from board metres to pixels: each pixel the mean of 6 x 6 rays.
Image drawn(const Chessboard& board, const Mat3& pixel_board) {
  constexpr int kRays = 6;
  const Mat3 board_pixel = pixel_board.inverse();
  Image image(640, 480);
  const auto brightness = [&](double u, double v) {
    const Vec2 p = (board_pixel * Vec3(u, v, 1)).hnormalized() / board.square_m;
    const int column = static_cast<int>(std::floor(p.x())) + 1, row = static_cast<int>(std::floor(p.y())) + 1;
    const bool is_print = column >= 0 && row >= 0 && column <= board.columns && row <= board.rows;
    return is_print && (column + row) % 2 == 0 ? 30.0 : 220.0;
  };
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      double sum = 0;
      for (int i = 0; i < kRays * kRays; ++i) {
        sum += brightness(u + (i % kRays + 0.5) / kRays - 0.5, v + (i / kRays + 0.5) / kRays - 0.5);
      }
      image.row(v)[u] = static_cast<std::uint8_t>(std::lround(sum / (kRays * kRays)));
    }
  }
  return image;
}

/// Board in the image's middle, turned, and farther away at its right.
Mat3 view(double turn_rad, double depth) {
  Mat3 to_middle, turn, image;
  to_middle << 1, 0, -0.1, 0, 1, -0.0625, 0, 0, 1;
  turn << std::cos(turn_rad), -std::sin(turn_rad), 0, std::sin(turn_rad), std::cos(turn_rad), 0, 0, 0, 1;
  image << 1400, 0, 318.3, 0, 1400, 241.7, depth, 0, 1;
  return image * turn * to_middle;
}

TEST(Chessboard, CornersAreFoundToAFewHundredthsOfAPixelInTheBoardsOwnOrderHoweverItIsTurned) {
  const Chessboard board;
  for (const double turn_deg : {0.0, 30.0, 90.0, 150.0, 180.0, 200.0, 270.0}) {
    const Mat3 pixel_board = view(turn_deg * kDegree, 1.5);
    const auto found = find_chessboard(drawn(board, pixel_board), board);
    ASSERT_TRUE(found) << turn_deg;
    const auto corners = board.p_board_corners();
    double squares = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 expected = (pixel_board * Vec3(corners[i].x(), corners[i].y(), 1)).hnormalized();
      squares += ((*found)[i] - expected).squaredNorm();
    }
    EXPECT_LT(std::sqrt(squares / 54), 0.08) << turn_deg;
  }
}

TEST(Chessboard, AnEmptyImageAndAnotherBoardShowNone) {
  EXPECT_FALSE(find_chessboard(Image(320, 240), {}));
  EXPECT_FALSE(find_chessboard(drawn({7, 6, 0.025}, view(0, 0)), {9, 6, 0.025}));
}

TEST(Chessboard, OnlyAnOddSumOfCornersHasOneOrientation) {
  EXPECT_TRUE((Chessboard{9, 6, 0.025}.has_one_orientation()));
  EXPECT_FALSE((Chessboard{8, 6, 0.025}.has_one_orientation()));
}

TEST(Chessboard, OnTheFloorTheFirstCornerLiesAheadAndToTheLeft) {
  const auto corners = BoardOnFloor{{2, 0.5}, 0}.p_vehicle_corners({9, 6, 0.1});
  EXPECT_LT((corners.front() - Vec2(2.25, 0.9)).norm(), 1e-12);
  EXPECT_LT((corners[8] - Vec2(2.25, 0.1)).norm(), 1e-12);
  EXPECT_LT((corners.back() - Vec2(1.75, 0.1)).norm(), 1e-12);
  const auto turned = BoardOnFloor{{2, 0.5}, kPi / 2}.p_vehicle_corners({9, 6, 0.1});
  EXPECT_LT((turned.front() - Vec2(1.6, 0.75)).norm(), 1e-12);
}

}  // namespace
}  // namespace aisle
