#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "aisle/core/angle.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "golden_files.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string calibration_problems(const std::string& text) {
  const auto calibration = parse_calibration(text, "camera.yaml");
  return calibration.ok() ? "none" : to_string(calibration.problems());
}

/// A valid file, with `line` after its first two lines.
std::string calibration_with(const std::string& line) {
  return "image_width: 640\nimage_height: 480\n" + line + "\nK: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n";
}

TEST(CalibrationFile, BothGoldenLayoutsAreReadAndWrittenAsTheyStand) {
  const auto opencv = read_calibration(kGolden / "calibration.opencv.yaml");
  ASSERT_TRUE(opencv.ok()) << to_string(opencv.problems());
  EXPECT_EQ(opencv_calibration_yaml(*opencv), *read_whole_file(kGolden / "calibration.opencv.yaml"));
  const auto ros = read_calibration(kGolden / "calibration.ros.yaml");
  ASSERT_TRUE(ros.ok()) << to_string(ros.problems());
  EXPECT_EQ(camera_info_yaml(*ros), *read_whole_file(kGolden / "calibration.ros.yaml"));
}

TEST(CalibrationFile, TheExamplesOfItsPageAreTheGoldenFiles) {
  const std::string page = *read_whole_file(fs::path(AISLE_SOURCE_DIR) / "docs/formats/calibration.md");
  EXPECT_THAT(page, HasSubstr(*read_whole_file(kGolden / "calibration.opencv.yaml")));
  EXPECT_THAT(page, HasSubstr(*read_whole_file(kGolden / "calibration.ros.yaml")));
}

TEST(CalibrationFile, EveryValueArrivesInItsField) {
  const auto c = read_calibration(kGolden / "calibration.opencv.yaml");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(c->camera_name, "front");
  EXPECT_EQ(c->width_px, 640);
  EXPECT_EQ(c->height_px, 480);
  const CameraIntrinsics& lens = c->intrinsics;
  EXPECT_THAT((std::array{lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px}),
              testing::ElementsAre(532.8, 532.9, 342.5, 233.9));
  EXPECT_THAT((std::array{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}),
              testing::ElementsAre(-0.28, 0.025, 0.0012, -0.00014, 0.16));
  EXPECT_EQ(c->rms_px, 0.195);
  ASSERT_TRUE(c->mount);
  EXPECT_EQ(c->mount->p_vehicle_camera, Vec3(0.4, -0.02, 1.15));
  EXPECT_DOUBLE_EQ(c->mount->tilt_rad, 12.5 * kDegree);
  EXPECT_DOUBLE_EQ(c->mount->pan_rad, -0.8 * kDegree);
  EXPECT_DOUBLE_EQ(c->mount->roll_rad, 0.3 * kDegree);
  EXPECT_EQ(c->laser_height_m, 0.3);
}

TEST(CalibrationFile, OpenCvReadsWhatIsWrittenAndPassesOurKeysOver) {
  cv::FileStorage file(*read_whole_file(kGolden / "calibration.opencv.yaml"),
                       cv::FileStorage::READ | cv::FileStorage::MEMORY);
  cv::Mat matrix, distortion;
  file["camera_matrix"] >> matrix;
  file["distortion_coefficients"] >> distortion;
  EXPECT_EQ(matrix.at<double>(1, 1), 532.9);
  EXPECT_EQ(matrix.at<double>(1, 2), 233.9);
  EXPECT_EQ(distortion.at<double>(4), 0.16);
}

TEST(CalibrationFile, WhatOpenCvWritesIsRead) {
  cv::FileStorage file(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "cameraMatrix" << cv::Mat(cv::Matx33d(400, 0, 300, 0, 401.25, 200, 0, 0, 1));
  file << "distCoeffs" << cv::Mat(cv::Matx<double, 1, 4>(-1e-7, 0.5, 0, 1));
  const auto c = parse_calibration(file.releaseAndGetString(), "x.yml");
  ASSERT_TRUE(c.ok()) << to_string(c.problems());
  EXPECT_EQ(c->width_px, 0);
  EXPECT_EQ(c->intrinsics.fy_px, 401.25);
  EXPECT_EQ(c->intrinsics.k1, -1e-7);
  EXPECT_EQ(c->intrinsics.p2, 1);
  EXPECT_EQ(c->intrinsics.k3, 0);
}

TEST(CalibrationFile, ARealFileOfOpenCvsIsRead) {
  const fs::path file = real_data() / "images/chessboard_opencv/left_intrinsics.yml";
  AISLE_NEEDS(file);
  const auto c = read_calibration(file);
  ASSERT_TRUE(c.ok()) << to_string(c.problems());
  EXPECT_NEAR(c->intrinsics.fx_px, 535.916, 0.001);
  EXPECT_NEAR(c->intrinsics.k3, 0.23839, 0.00001);
  EXPECT_NEAR(*c->rms_px, 0.3926, 0.0001);
}

/// What comes back when a calibration is written in both layouts and read again.
void expect_written_back(const CameraCalibration& c) {
  for (const std::string& text : {opencv_calibration_yaml(c), camera_info_yaml(c)}) {
    const auto again = parse_calibration(text, "written.yaml");
    ASSERT_TRUE(again.ok()) << to_string(again.problems()) << text;
    EXPECT_EQ(again->intrinsics, c.intrinsics);
    EXPECT_EQ(again->width_px, c.width_px);
    EXPECT_EQ(again->camera_name, c.camera_name);
  }
}

/// image_pipeline#682: four fisheye coefficients were taken for plumb_bob's.
TEST(CalibrationFile, AFisheyeLensIsEquidistantWhateverItIsCalled) {
  for (const std::string name :
       {"camera_model: fisheye", "distortion_model: fisheye", "distortion_model: equidistant",
        "camera_model: pinhole\ndistortion_model: equidistant", "fisheye_model: 1"}) {
    const auto c = parse_calibration(calibration_with(name + "\nD: [0.1, -0.03, 0.004, -0.0007]"), "c.yaml");
    ASSERT_TRUE(c.ok()) << to_string(c.problems());
    EXPECT_EQ(c->intrinsics.model, LensModel::kEquidistant);
    EXPECT_EQ(c->intrinsics.k3, 0.004);
    EXPECT_EQ(c->intrinsics.k4, -0.0007);
    EXPECT_EQ(c->intrinsics.p1, 0);
    expect_written_back(*c);
  }
}

TEST(CalibrationFile, EightCoefficientsAreARationalLens) {
  for (const std::string name : {"distortion_model: rational_polynomial", ""}) {
    const auto c = parse_calibration(
        calibration_with(name + "\nD: [-0.28, 0.025, 0.0012, -0.00014, 0.16, 0.01, 0.02, 0.003]"), "c.yaml");
    ASSERT_TRUE(c.ok()) << to_string(c.problems());
    EXPECT_EQ(c->intrinsics.model, LensModel::kRationalPolynomial);
    EXPECT_EQ(c->intrinsics.k3, 0.16);
    EXPECT_EQ(c->intrinsics.k6, 0.003);
    expect_written_back(*c);
  }
}

const std::string kCamera =
    ":\n  camera_model: pinhole\n  distortion_coeffs: [-0.28, 0.025, 0.0012, -0.00014]\n"
    "  distortion_model: radtan\n  intrinsics: [532.8, 532.9, 342.5, 233.9]\n  resolution: [640, 480]\n";

TEST(CalibrationFile, KalibrsCamchainIsRead) {
  const auto c = parse_calibration("cam0" + kCamera, "chain.yaml");
  ASSERT_TRUE(c.ok()) << to_string(c.problems());
  EXPECT_EQ(c->camera_name, "cam0");
  EXPECT_EQ(c->width_px, 640);
  EXPECT_EQ(c->height_px, 480);
  EXPECT_EQ(c->intrinsics.fy_px, 532.9);
  EXPECT_EQ(c->intrinsics.cx_px, 342.5);
  EXPECT_EQ(c->intrinsics.model, LensModel::kPlumbBob);
  EXPECT_EQ(c->intrinsics.p2, -0.00014);
  expect_written_back(*c);
  EXPECT_EQ(calibration_problems("cam0" + kCamera + "cam1" + kCamera),
            "camera.yaml:1: has the cameras cam0, cam1; leave only the one that is meant in the file");
}

TEST(CalibrationFile, OtherLensesAreRefusedWithTheirLine) {
  EXPECT_EQ(calibration_problems(calibration_with("distortion_model: fov")),
            "camera.yaml:3: distortion_model: 'fov' is none of plumb_bob (radtan), rational_polynomial, "
            "equidistant (fisheye)");
  EXPECT_THAT(calibration_problems(calibration_with("camera_model: omni")), HasSubstr("'omni' is none of"));
  EXPECT_THAT(calibration_problems(calibration_with("distortion_model: plumb_bob\nfisheye_model: 1")),
              HasSubstr("camera.yaml:4: fisheye_model: says equidistant, but the file also says plumb_bob"));
  EXPECT_THAT(
      calibration_problems(calibration_with("distortion_model: plumb_bob\nD: [0, 0, 0, 0, 0, 0.1, 0, 0]")),
      HasSubstr("camera.yaml:4: D: has 8 coefficients; the model plumb_bob has 5"));
  EXPECT_THAT(calibration_problems(calibration_with("D: [0, 0, 0, 0, 0, 0, 0, 0, 0.1, 0, 0, 0]")),
              HasSubstr("D: has 12 coefficients"));
  EXPECT_THAT(calibration_problems(calibration_with("distortion_model: equidistant\nD: [0, 0, 0, 0, 0.1]")),
              HasSubstr("D: has 5 coefficients; the equidistant model has 4"));
  EXPECT_EQ(calibration_problems(calibration_with("D: [0.1, 0, 0, 0, 0, 0, 0, 0]")), "none");
  EXPECT_THAT(calibration_problems("K: [500, 1, 320, 0, 500, 240, 0, 0, 1]"), HasSubstr("skew"));
  EXPECT_THAT(calibration_problems(calibration_with("image_width: 641")),
              HasSubstr("camera.yaml:3: image_width: is given twice, first on line 1"));
}

TEST(CalibrationFile, ProblemsNameLineAndKey) {
  EXPECT_EQ(calibration_problems(""),
            "camera.yaml:1: is not a calibration: expected keys such as camera_matrix");
  EXPECT_EQ(calibration_problems("image_width: 640\nimage_height: 480"),
            "camera.yaml:1: camera_matrix: is missing");
  EXPECT_THAT(calibration_problems("K: [1, 2"), HasSubstr("is not YAML"));
  EXPECT_EQ(calibration_problems("\nK: [1, 2, 3]"),
            "camera.yaml:2: K: has 3 numbers, not the 9 of a camera matrix");
  EXPECT_EQ(calibration_problems("K: [500, 0, 320, 0, -5, 240, 0, 0, 1]"),
            "camera.yaml:1: K: the focal lengths are not positive");
  EXPECT_THAT(calibration_problems("K: [500, 0, .nan, 0, 500, 240, 0, 0, 1]"),
              HasSubstr("K: '.nan' is not a number"));
  EXPECT_THAT(calibration_problems(calibration_with("laser_height_m: high")),
              HasSubstr("camera.yaml:3: laser_height_m: 'high'"));
  EXPECT_THAT(calibration_problems(
                  calibration_with("vehicle_mount: {x_m: 0, y_m: 0, z_m: 1, tilt_deg: 99, pan_deg: 0}")),
              AllOf(HasSubstr("camera.yaml:3: vehicle_mount.tilt_deg: 99 is outside -90 .. 90"),
                    HasSubstr("vehicle_mount.roll_deg: is missing")));
  EXPECT_THAT(calibration_problems("image_width: 640\nK: [500, 0, 320, 0, 500, 240, 0, 0, 1]"),
              HasSubstr("image_height: is missing, though the other side is given"));
}

}  // namespace
}  // namespace aisle
