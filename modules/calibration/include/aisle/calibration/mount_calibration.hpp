#pragma once
/// How a camera sits on the vehicle, from points of the floor whose places in base_link and in the image
/// are known: corners of a chessboard that lies there, or marks.

#include <optional>
#include <span>
#include <vector>

#include "aisle/calibration/verdict.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// A point of the floor and the pixel that shows it.
struct FloorMark {
  Vec2 pixel_px = Vec2::Zero();
  Vec2 p_vehicle = Vec2::Zero();
};

struct MountCalibrationParams {
  double pixel_px = 0.5;  ///< how exactly the pixels are expected to be known: standard deviation
};

struct MountCalibration {
  CameraMount mount;
  CameraMount deviations;          ///< standard deviation of each value; the lens is taken as exact
  double rms_px = 0;               ///< of the marks that fit
  std::vector<Vec2> residuals_px;  ///< seen minus expected, by mark; NaN for one that the mount cannot show
  std::vector<bool> fits;          ///< false: an outlier that is left out
  /// Another mount explains the marks nearly as well, as when they are seen from afar and head-on.
  bool is_ambiguous = false;
  CalibrationVerdict verdict;
};

inline constexpr std::size_t kFloorMarksMin = 4;

/// The mount that shows the marks where they are seen, by least squares of the distances in pixels with a
/// loss that lets single wrong marks pass.
/// @param marks  at least kFloorMarksMin, or it throws std::invalid_argument
/// @return nullopt if they determine no mount: they lie on one line, or no camera above the floor sees them
/// so
std::optional<MountCalibration> calibrate_mount(std::span<const FloorMark> marks, const CameraModel& lens,
                                                const MountCalibrationParams& params = {});

/// Whether the marks lie so nearly on one line that no mount follows from them.
bool are_on_one_line(std::span<const FloorMark> marks);

/// Tilt, pan and roll of a rotation. Looking straight down, pan is 0.
CameraMount mount_of(const Mat3& R_vehicle_camera, const Vec3& p_vehicle_camera);

/// What the figures of a calibration mean.
CalibrationVerdict judge(const MountCalibration& calibration);

}  // namespace aisle
