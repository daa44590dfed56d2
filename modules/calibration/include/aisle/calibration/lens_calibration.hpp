#pragma once
/// A camera's lens from several views of a chessboard (Zhang's method, as OpenCV implements it).

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aisle/calibration/camera_calibration.hpp"
#include "aisle/calibration/chessboard.hpp"
#include "aisle/calibration/verdict.hpp"

namespace aisle {

/// An image in which the board was found.
struct BoardView {
  std::string name;
  std::vector<Vec2> corners_px;  ///< as find_chessboard gives them
};

struct LensCalibrationParams {
  bool same_focal_lengths = false;  ///< fx = fy: the pixels are known to be square
};

/// What one view says of the lens.
struct CalibratedView {
  std::string name;
  double rms_px = 0;
  Mat3 R_camera_board = Mat3::Identity();
  Vec3 p_camera_board = Vec3::Zero();  ///< the board's first corner
  std::vector<Vec2> corners_px;
  std::vector<Vec2> residuals_px;  ///< seen minus expected, by corner
};

struct LensCalibration {
  int width_px = 0;
  int height_px = 0;
  CameraIntrinsics intrinsics;
  CameraIntrinsics deviations;  ///< standard deviation of each value
  double rms_px = 0;
  std::vector<CalibratedView> views;
  double coverage = 0;          ///< share of the image's cells, 8 x 6, that held a corner
  double largest_turn_rad = 0;  ///< between the directions that two views saw the board face
  CalibrationVerdict verdict;
};

inline constexpr std::size_t kLensViewsMin = 3;

/// @param views  of images of the same size; at least kLensViewsMin, each with all corners, or it throws
///               std::invalid_argument
/// @return nullopt if the views determine no lens at all, as when all are the same
std::optional<LensCalibration> calibrate_lens(std::span<const BoardView> views, const Chessboard& board,
                                              int width_px, int height_px,
                                              const LensCalibrationParams& params = {});

/// What the figures of a calibration mean.
CalibrationVerdict judge(const LensCalibration& calibration);

}  // namespace aisle
