#pragma once

#include <optional>
#include <span>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// Where a board is as a camera of known lens sees it.
struct BoardPose {
  Mat3 R_camera_board = Mat3::Identity();
  Vec3 p_camera_board = Vec3::Zero();  ///< the board's first corner
};

/// @param corners_px  as find_chessboard gives them
/// @return nullopt if they show no board in front of the camera
std::optional<BoardPose> board_pose(std::span<const Vec2> corners_px, const Chessboard& board,
                                    const CameraModel& lens);

}  // namespace aisle
