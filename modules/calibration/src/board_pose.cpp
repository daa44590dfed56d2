#include "aisle/calibration/board_pose.hpp"

#include <opencv2/calib3d.hpp>

#include "images.hpp"

namespace aisle {

std::optional<BoardPose> board_pose(std::span<const Vec2> corners_px, const Chessboard& board,
                                    const CameraModel& lens) {
  std::vector<cv::Point2f> slopes;
  for (const Vec2& corner_px : corners_px) {
    const auto ray = lens.ray(corner_px);
    if (!ray) return std::nullopt;
    slopes.push_back(to_cv(Vec2(ray->direction.head<2>())));
  }
  const auto points = to_cv(board.p_board_corners());
  cv::Mat turn, shift;
  try {
    if (!cv::solvePnP(points, slopes, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE)) {
      return std::nullopt;
    }
    cv::solvePnPRefineLM(points, slopes, cv::Matx33d::eye(), cv::noArray(), turn, shift);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  cv::Matx33d rotation;
  cv::Rodrigues(turn, rotation);
  const BoardPose pose{to_eigen(rotation), {shift.at<double>(0), shift.at<double>(1), shift.at<double>(2)}};
  if (!pose.R_camera_board.allFinite() || !(pose.p_camera_board.z() > 0)) return std::nullopt;
  return pose;
}

}  // namespace aisle
