#include "aisle/calibration/mount_calibration.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "mount_start.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const CameraModel kTangentialLens({500, 505, 320, 240, -0.2, 0.05, 0.001, -0.001, 0});

CameraMount tilted_mount() {
  return {{0.4, -0.03, 1.1}, 22 * kDegree, 3 * kDegree, -1 * kDegree};
}

/// The corners of a board on the floor as the mounted camera sees them, with noise.
std::vector<FloorMark> seen_board(const CameraMount& mount, const BoardOnFloor& place, double noise_px,
                                  Random& random) {
  std::vector<FloorMark> marks;
  for (const Vec2& p : place.p_vehicle_corners({9, 6, 0.1})) {
    const auto pixel = kTangentialLens.project(mount.to_camera({p.x(), p.y(), 0}));
    if (!pixel) continue;
    marks.push_back({*pixel + Vec2(random.normal(noise_px), random.normal(noise_px)), p});
  }
  return marks;
}

void expect_equal(const CameraMount& a, const CameraMount& b, double tolerance) {
  EXPECT_LT((a.p_vehicle_camera - b.p_vehicle_camera).norm(), tolerance);
  EXPECT_NEAR(a.tilt_rad, b.tilt_rad, tolerance);
  EXPECT_NEAR(wrap_angle(a.pan_rad - b.pan_rad), 0, tolerance);
  EXPECT_NEAR(wrap_angle(a.roll_rad - b.roll_rad), 0, tolerance);
}

RC_GTEST_PROP(MountCalibration, AnglesComeBackFromTheirRotation, ()) {
  const auto angle = [](int limit_deg) { return *rc::gen::inRange(-limit_deg, limit_deg) * kDegree; };
  const CameraMount mount{{1, 2, 3}, angle(89), angle(179), angle(179)};
  const CameraMount back = mount_of(mount.R_vehicle_camera(), mount.p_vehicle_camera);
  RC_ASSERT(std::abs(back.tilt_rad - mount.tilt_rad) < 1e-9);
  RC_ASSERT(std::abs(back.pan_rad - mount.pan_rad) < 1e-9);
  RC_ASSERT(std::abs(back.roll_rad - mount.roll_rad) < 1e-9);
}

TEST(MountCalibration, ExactPixelsGiveTheExactMount) {
  Random random(1);
  const auto marks = seen_board(tilted_mount(), {{2.2, 0.1}, 0.2}, 0, random);
  const auto found = calibrate_mount(marks, kTangentialLens);
  ASSERT_TRUE(found);
  expect_equal(found->mount, tilted_mount(), 1e-7);
  EXPECT_LT(found->rms_px, 1e-6);
}

TEST(MountCalibration, ErrorsAreAsLargeAsTheirStatedDeviations) {
  constexpr int kTrials = 200;
  constexpr double kNoise_px = 0.3;
  Eigen::Matrix<double, 6, 1> squares = Eigen::Matrix<double, 6, 1>::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    Random random(static_cast<std::uint64_t>(trial));
    const auto marks = seen_board(tilted_mount(), {{2.2, 0.1}, 0.2}, kNoise_px, random);
    const auto found = calibrate_mount(marks, kTangentialLens, {.pixel_px = kNoise_px});
    ASSERT_TRUE(found);
    const CameraMount& truth = tilted_mount();
    const CameraMount &m = found->mount, &d = found->deviations;
    Eigen::Matrix<double, 6, 1> errors;
    errors << (m.p_vehicle_camera - truth.p_vehicle_camera).cwiseQuotient(d.p_vehicle_camera),
        (m.tilt_rad - truth.tilt_rad) / d.tilt_rad, (m.pan_rad - truth.pan_rad) / d.pan_rad,
        (m.roll_rad - truth.roll_rad) / d.roll_rad;
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 4.5) << "trial " << trial;
    squares += errors.cwiseProduct(errors);
  }
  for (const double mean : squares / kTrials) EXPECT_NEAR(mean, 1, 0.35);
}

TEST(MountCalibration, AnOrdinaryViewMeetsTwoMillimetresAndATwentiethOfADegree) {
  for (const double tilt_deg : {10.0, 20.0, 35.0, 60.0}) {
    CameraMount truth = tilted_mount();
    truth.tilt_rad = tilt_deg * kDegree;
    const double ahead_m = 0.4 + 1.1 / std::tan(std::max(tilt_deg, 25.0) * kDegree);
    Random random(5);
    const auto marks = seen_board(truth, {{ahead_m, 0.1}, 0.2}, 0.1, random);
    const auto found = calibrate_mount(marks, kTangentialLens, {.pixel_px = 0.1});
    ASSERT_TRUE(found) << tilt_deg;
    EXPECT_NEAR(found->mount.p_vehicle_camera.z(), 1.1, 0.002) << tilt_deg;
    EXPECT_NEAR(to_degrees(found->mount.tilt_rad), tilt_deg, 0.05) << tilt_deg;
    EXPECT_EQ(found->verdict.quality, CalibrationQuality::kGood) << tilt_deg;
  }
}

TEST(MountCalibration, OneWrongMarkIsFoundAndDoesNotMoveTheMount) {
  Random random(3);
  auto marks = seen_board(tilted_mount(), {{2.2, 0.1}, 0.2}, 0.2, random);
  marks[7].pixel_px += Vec2(40, -25);
  const auto found = calibrate_mount(marks, kTangentialLens);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mount.p_vehicle_camera.z(), 1.1, 0.004);
  for (std::size_t i = 0; i < marks.size(); ++i) EXPECT_EQ(found->fits[i], i != 7) << i;
  EXPECT_EQ(found->verdict.quality, CalibrationQuality::kUsable);
  EXPECT_THAT(found->verdict.reasons, testing::Contains(HasSubstr("1 of 54 points do not fit")));
}

TEST(MountCalibration, MarksOnOneLineGiveNoMount) {
  std::vector<FloorMark> marks;
  for (int i = 0; i < 8; ++i) marks.push_back({{300.0 + 5 * i, 400.0 - 30 * i}, {1 + 0.4 * i, 0.5}});
  EXPECT_TRUE(are_on_one_line(marks));
  EXPECT_FALSE(calibrate_mount(marks, kTangentialLens));
}

TEST(MountCalibration, TooFewMarksAreABrokenContract) {
  EXPECT_THROW(calibrate_mount(std::vector<FloorMark>(3), kTangentialLens), std::invalid_argument);
}

TEST(MountCalibration, ASmallBoardFarAwayIsNotCalledGood) {
  Random random(4);
  std::vector<FloorMark> marks;
  for (const Vec2& p : BoardOnFloor{{6, 0}, 0}.p_vehicle_corners({9, 6, 0.02})) {
    const auto pixel = kTangentialLens.project(tilted_mount().to_camera({p.x(), p.y(), 0}));
    ASSERT_TRUE(pixel);
    marks.push_back({*pixel + Vec2(random.normal(0.3), random.normal(0.3)), p});
  }
  const auto found = calibrate_mount(marks, kTangentialLens);
  if (found) {
    EXPECT_EQ(found->verdict.quality, CalibrationQuality::kPoor);
  }
}

}  // namespace
}  // namespace aisle
