#pragma once

#include <memory>
#include <optional>
#include <string>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/odometry_history.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct ImageMonitorParams {
  double age_max_s = 0.5;
  double dark_level = 10;
  double bright_level = 248;

  void describe(FieldList& fields);
};

/// Checks that a camera still works: its images arrive in time, change while the vehicle moves, and are
/// neither black nor washed out. While it stands, equal images say nothing: a camera without noise sees the
/// same again.
class ImageMonitor {
 public:
  ImageMonitor(const ImageMonitorParams& params, const CameraDescription& camera)
      : params_(params), camera_(camera) {}

  /// Once a cycle, with every observation.
  /// @param odometry  up to this observation
  /// @return the camera's image if this observation has one that can be trusted; nullptr otherwise. It may be
  ///         up to `age_max_s` old, and shows what was seen from `odometry.T_odom_at(its stamp)`. Points into
  ///         the observation
  const CameraImage* look(const Observation& observation, const OdometryHistory& odometry);

  /// What is wrong now, as text for the user: "camera front is frozen"; nullopt if nothing is.
  std::optional<std::string> trouble(double now_s) const;

 private:
  bool is_frozen(const CameraImage& image, const Pose2& T_odom_taken);
  const char* fault_of(const CameraImage& image, const OdometryHistory& odometry);

  ImageMonitorParams params_;
  CameraDescription camera_;
  std::shared_ptr<const Image> shown_;
  Pose2 T_odom_shown_;                  ///< where the vehicle was when that was first shown
  std::optional<double> good_stamp_s_;  ///< of the last good image
  const char* what_ = "has sent no image";
};

}  // namespace aisle
