#include "aisle/calibration/lens_calibration.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::Contains;
using testing::HasSubstr;

const CameraIntrinsics kTruth{530, 533, 330, 236, -0.25, 0.08, 0.001, -0.0008, 0};
const Chessboard kBoard{9, 6, 0.03};

/// The board 0.4 m to 0.7 m away, somewhere in the image, turned by up to `turn_deg` about two axes.
std::vector<BoardView> views(int count, double turn_deg, double noise_px, Random& random) {
  const CameraModel lens(kTruth);
  std::vector<BoardView> result;
  while (static_cast<int>(result.size()) < count) {
    const auto turn = [&] { return random.uniform(-turn_deg, turn_deg) * kDegree; };
    const double about_y_rad = turn(), about_x_rad = turn();
    const Mat3 R_camera_board =
        (Eigen::AngleAxisd(about_x_rad, Vec3::UnitX()) * Eigen::AngleAxisd(about_y_rad, Vec3::UnitY()))
            .toRotationMatrix();
    const Vec3 p_camera_board{random.uniform(-0.4, 0.15), random.uniform(-0.3, 0.1),
                              random.uniform(0.4, 0.7)};
    BoardView view{"view " + std::to_string(result.size()), {}};
    for (const Vec3& p : kBoard.p_board_corners()) {
      const auto pixel = lens.project(R_camera_board * p + p_camera_board);
      if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > 639 || pixel->y() > 479) break;
      view.corners_px.push_back(*pixel + Vec2(random.normal(noise_px), random.normal(noise_px)));
    }
    if (view.corners_px.size() == 54) result.push_back(view);
  }
  return result;
}

TEST(LensCalibration, ExactCornersGiveTheExactLens) {
  Random random(1);
  const auto found = calibrate_lens(views(12, 40, 0, random), kBoard, 640, 480);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->intrinsics.fx_px, kTruth.fx_px, 0.05);
  EXPECT_NEAR(found->intrinsics.fy_px, kTruth.fy_px, 0.05);
  EXPECT_NEAR(found->intrinsics.cx_px, kTruth.cx_px, 0.05);
  EXPECT_NEAR(found->intrinsics.k1, kTruth.k1, 1e-3);
  EXPECT_LT(found->rms_px, 0.001);
  EXPECT_EQ(found->verdict.quality, CalibrationQuality::kGood)
      << testing::PrintToString(found->verdict.reasons);
}

TEST(LensCalibration, ErrorsAreAsLargeAsTheirStatedDeviations) {
  constexpr int kTrials = 30;
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    Random random(static_cast<std::uint64_t>(trial));
    const auto found = calibrate_lens(views(10, 40, 0.2, random), kBoard, 640, 480);
    ASSERT_TRUE(found);
    const CameraIntrinsics &c = found->intrinsics, &d = found->deviations;
    const Eigen::Vector4d errors((c.fx_px - kTruth.fx_px) / d.fx_px, (c.fy_px - kTruth.fy_px) / d.fy_px,
                                 (c.cx_px - kTruth.cx_px) / d.cx_px, (c.k1 - kTruth.k1) / d.k1);
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 4.5) << "trial " << trial;
    EXPECT_NEAR(found->rms_px, 0.2 * std::sqrt(2), 0.03);
    squares += errors.cwiseProduct(errors);
  }
  for (const double mean : squares / kTrials) EXPECT_NEAR(mean, 1, 0.7);
}

TEST(LensCalibration, ABoardThatIsNeverTurnedIsPoorAndTheReasonIsNamed) {
  Random random(2);
  const auto found = calibrate_lens(views(10, 4, 0.2, random), kBoard, 640, 480);
  if (!found) return;
  EXPECT_EQ(found->verdict.quality, CalibrationQuality::kPoor);
  EXPECT_THAT(found->verdict.reasons, Contains(HasSubstr("turn it to all sides")));
}

TEST(LensCalibration, TheSameViewAgainAndAgainIsPoorOrNothing) {
  Random random(3);
  const auto one = views(1, 40, 0.2, random);
  const auto found = calibrate_lens(std::vector<BoardView>(5, one[0]), kBoard, 640, 480);
  if (found) {
    EXPECT_EQ(found->verdict.quality, CalibrationQuality::kPoor);
  }
}

TEST(LensCalibration, AViewWithWrongCornersIsNamed) {
  Random random(4);
  auto seen = views(12, 40, 0.2, random);
  for (Vec2& corner : seen[5].corners_px) corner.x() += random.uniform(-3, 3);
  const auto found = calibrate_lens(seen, kBoard, 640, 480);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->verdict.reasons, Contains(HasSubstr("view 5 fits badly")));
}

TEST(LensCalibration, OneFocalLengthCanBeAskedFor) {
  Random random(5);
  const auto found =
      calibrate_lens(views(8, 40, 0.2, random), kBoard, 640, 480, {.same_focal_lengths = true});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->intrinsics.fx_px, found->intrinsics.fy_px);
  EXPECT_GT(found->deviations.fx_px, 0);
}

TEST(LensCalibration, TooFewOrIncompleteViewsAreABrokenContract) {
  Random random(6);
  auto seen = views(3, 40, 0, random);
  seen[0].corners_px.pop_back();
  EXPECT_THROW(calibrate_lens(seen, kBoard, 640, 480), std::invalid_argument);
  EXPECT_THROW(calibrate_lens(std::span(seen).first(2), kBoard, 640, 480), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
