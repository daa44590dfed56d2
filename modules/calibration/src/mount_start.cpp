#include "mount_start.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "images.hpp"

namespace aisle {
namespace {

/// The marks as the pinhole of focal length 1 sees them, centred on the floor for the solver's sake.
struct PlaneImage {
  Vec3 p_vehicle_middle = Vec3::Zero();
  std::vector<cv::Point3d> floor;
  std::vector<cv::Point2d> slopes;
};

PlaneImage plane_image(std::span<const FloorMark> marks, const CameraModel& lens) {
  PlaneImage image;
  for (const FloorMark& mark : marks) {
    image.p_vehicle_middle.head<2>() += mark.p_vehicle / static_cast<double>(marks.size());
  }
  for (const FloorMark& mark : marks) {
    const auto ray = lens.ray(mark.pixel_px);
    if (!ray) continue;
    const Vec2 p = mark.p_vehicle - image.p_vehicle_middle.head<2>();
    image.floor.emplace_back(p.x(), p.y(), 0);
    image.slopes.emplace_back(ray->direction.x(), ray->direction.y());
  }
  return image;
}

}  // namespace

CameraMount mount_of(const Mat3& R_vehicle_camera, const Vec3& p_vehicle_camera) {
  // Column 2 looks along the optical axis: (cos tilt cos pan, cos tilt sin pan, -sin tilt); columns 0 and 1
  // point right and down, and roll leans them.
  CameraMount mount;
  mount.p_vehicle_camera = p_vehicle_camera;
  mount.tilt_rad = std::asin(std::clamp(-R_vehicle_camera(2, 2), -1.0, 1.0));
  if (std::hypot(R_vehicle_camera(0, 2), R_vehicle_camera(1, 2)) > 1e-9)
    mount.pan_rad = std::atan2(R_vehicle_camera(1, 2), R_vehicle_camera(0, 2));
  CameraMount upright = mount;
  upright.roll_rad = 0;
  const Mat3 leaning = upright.R_vehicle_camera().transpose() * R_vehicle_camera;
  mount.roll_rad = std::atan2(leaning(1, 0), leaning(0, 0));
  return mount;
}

std::vector<CameraMount> mount_starts(std::span<const FloorMark> marks, const CameraModel& lens) {
  const PlaneImage image = plane_image(marks, lens);
  if (image.floor.size() < kFloorMarksMin) return {};
  std::vector<cv::Mat> turns, shifts;
  try {
    cv::solvePnPGeneric(image.floor, image.slopes, cv::Matx33d::eye(), cv::noArray(), turns, shifts, false,
                        cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return {};
  }
  std::vector<CameraMount> starts;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    cv::Matx33d rotation;
    cv::Rodrigues(turns[i], rotation);
    const Mat3 R_vehicle_camera = to_eigen(rotation).transpose();
    const Vec3 shift(shifts[i].at<double>(0), shifts[i].at<double>(1), shifts[i].at<double>(2));
    const Vec3 p_vehicle_camera = image.p_vehicle_middle - R_vehicle_camera * shift;
    const bool is_above_the_floor = R_vehicle_camera.allFinite() && p_vehicle_camera.z() > 0;
    if (is_above_the_floor) starts.push_back(mount_of(R_vehicle_camera, p_vehicle_camera));
  }
  return starts;
}

}  // namespace aisle
