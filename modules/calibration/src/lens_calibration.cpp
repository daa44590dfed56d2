#include "aisle/calibration/lens_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <set>
#include <stdexcept>

#include "images.hpp"

namespace aisle {
namespace {

/// What OpenCV answers, in its own types.
struct Solution {
  cv::Mat matrix = cv::Mat::eye(3, 3, CV_64F);
  cv::Mat distortion;
  cv::Mat deviations;
  cv::Mat view_rms_px;
  std::vector<cv::Mat> turns, shifts;
  double rms_px = 0;
};

Solution solve(std::span<const BoardView> views, const std::vector<cv::Point3f>& board, const cv::Size& size,
               const LensCalibrationParams& params) {
  std::vector<std::vector<cv::Point2f>> seen;
  for (const BoardView& view : views) seen.push_back(to_cv(view.corners_px));
  const std::vector<std::vector<cv::Point3f>> boards(seen.size(), board);
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-12);
  Solution s;
  cv::Mat pose_deviations;
  s.rms_px = cv::calibrateCamera(boards, seen, size, s.matrix, s.distortion, s.turns, s.shifts, s.deviations,
                                 pose_deviations, s.view_rms_px,
                                 params.same_focal_lengths ? cv::CALIB_FIX_ASPECT_RATIO : 0, until);
  return s;
}

CameraIntrinsics intrinsics_of(const Solution& s) {
  const auto k = [&](int row, int column) { return s.matrix.at<double>(row, column); };
  const auto d = [&](int i) { return s.distortion.at<double>(i); };
  return {k(0, 0), k(1, 1), k(0, 2), k(1, 2), d(0), d(1), d(2), d(3), d(4)};
}

/// OpenCV divides the squared residuals by its number of corners, though each has two coordinates.
double deviation_correction(const Solution& s, std::size_t corners, bool same_focal_lengths) {
  const double unknowns = (same_focal_lengths ? 8.0 : 9.0) + 6.0 * static_cast<double>(s.turns.size());
  const auto points = static_cast<double>(corners);
  return std::sqrt(std::max(1.0, points - unknowns) / std::max(1.0, 2 * points - unknowns));
}

CameraIntrinsics deviations_of(const Solution& s, std::size_t corners, bool same_focal_lengths) {
  const double correction = deviation_correction(s, corners, same_focal_lengths);
  const auto d = [&](int i) { return correction * s.deviations.at<double>(i); };
  // With one focal length OpenCV states the deviation of fy alone.
  const double fx = same_focal_lengths ? std::max(d(0), d(1)) : d(0);
  return {fx, d(1), d(2), d(3), d(4), d(5), d(6), d(7), d(8)};
}

CalibratedView calibrated_view(const BoardView& view, const Solution& s, std::size_t index,
                               const std::vector<cv::Point3f>& board) {
  CalibratedView result;
  result.name = view.name;
  result.corners_px = view.corners_px;
  result.rms_px = s.view_rms_px.at<double>(static_cast<int>(index));
  cv::Matx33d rotation;
  cv::Rodrigues(s.turns[index], rotation);
  result.R_camera_board = to_eigen(rotation);
  for (int i = 0; i < 3; ++i) result.p_camera_board[i] = s.shifts[index].at<double>(i);
  std::vector<cv::Point2f> expected;
  cv::projectPoints(board, s.turns[index], s.shifts[index], s.matrix, s.distortion, expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    result.residuals_px.push_back(view.corners_px[i] - Vec2(expected[i].x, expected[i].y));
  }
  return result;
}

double coverage(const LensCalibration& calibration) {
  constexpr int kColumns = 8, kRows = 6;
  std::set<int> cells;
  for (const CalibratedView& view : calibration.views) {
    for (const Vec2& p : view.corners_px) {
      const int column = static_cast<int>((p.x() + 0.5) / calibration.width_px * kColumns);
      const int row = static_cast<int>((p.y() + 0.5) / calibration.height_px * kRows);
      cells.insert(std::clamp(row, 0, kRows - 1) * kColumns + std::clamp(column, 0, kColumns - 1));
    }
  }
  return static_cast<double>(cells.size()) / (kColumns * kRows);
}

double largest_turn_rad(const std::vector<CalibratedView>& views) {
  double largest = 0;
  for (const CalibratedView& a : views) {
    for (const CalibratedView& b : views) {
      const double cosine = a.R_camera_board.col(2).dot(b.R_camera_board.col(2));
      largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
  }
  return largest;
}

bool is_a_lens(const CameraIntrinsics& c, double rms_px) {
  const std::array values{c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1, c.p2, c.k3, rms_px};
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }) &&
         c.fx_px > 0 && c.fy_px > 0;
}

void check(std::span<const BoardView> views, const Chessboard& board) {
  const auto corners = static_cast<std::size_t>(board.columns * board.rows);
  const bool complete = std::all_of(views.begin(), views.end(),
                                    [&](const BoardView& view) { return view.corners_px.size() == corners; });
  if (views.size() < kLensViewsMin || !complete) {
    throw std::invalid_argument("calibrate_lens: at least 3 views with all corners are needed");
  }
}

}  // namespace

std::optional<LensCalibration> calibrate_lens(std::span<const BoardView> views, const Chessboard& board,
                                              int width_px, int height_px,
                                              const LensCalibrationParams& params) {
  check(views, board);
  const auto board_corners = to_cv(board.p_board_corners());
  Solution solution;
  try {
    solution = solve(views, board_corners, {width_px, height_px}, params);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  LensCalibration result{width_px, height_px, intrinsics_of(solution)};
  if (!is_a_lens(result.intrinsics, solution.rms_px)) return std::nullopt;
  result.deviations = deviations_of(solution, views.size() * board_corners.size(), params.same_focal_lengths);
  result.rms_px = solution.rms_px;
  for (std::size_t i = 0; i < views.size(); ++i) {
    result.views.push_back(calibrated_view(views[i], solution, i, board_corners));
  }
  result.coverage = coverage(result);
  result.largest_turn_rad = largest_turn_rad(result.views);
  result.verdict = judge(result);
  return result;
}

}  // namespace aisle
