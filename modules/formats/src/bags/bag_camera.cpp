#include "aisle/formats/bags/bag_camera.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/calibration/mount_calibration.hpp"
#include "aisle/vehicle/camera_description.hpp"
#include "calibration_lens.hpp"
#include "field_reader.hpp"
#include "other_lens.hpp"

namespace aisle {
namespace {

constexpr double kToTheSky = 0.9;  ///< cosine; no camera of a vehicle looks there

/// What a vehicle file cannot say of a camera; empty: it can say all.
std::string outside_ranges(CameraDescription camera) {
  OtherLens lens(camera.intrinsics);
  FieldList fields = fields_of(camera);
  lens.describe(fields);
  for (const Field& field : fields.all()) {
    const auto* const real = std::get_if<double*>(&field.target);
    if (real == nullptr) continue;
    const double value = **real / field.inner_unit;
    if (!(value >= field.range.min && value <= field.range.max))
      return fmt::format("{} {:g} is outside {:g} .. {:g}", field.key, value, field.range.min,
                         field.range.max);
  }
  return "";
}

/// Camera matrix and distortion, or the projection of images that were rectified since.
/// @return what is wrong; empty: nothing
std::string set_lens(const ros::CameraInfo& info, bool is_rectified, CameraIntrinsics& lens) {
  const auto model = lens_model_named(is_rectified ? "none" : info.distortion_model);
  if (!model) return fmt::format("its lens model '{}' is not read", printable(info.distortion_model));
  lens.fx_px = is_rectified ? info.p[0] : info.k[0];
  lens.cx_px = is_rectified ? info.p[2] : info.k[2];
  lens.fy_px = is_rectified ? info.p[5] : info.k[4];
  lens.cy_px = is_rectified ? info.p[6] : info.k[5];
  if ((is_rectified ? info.p[1] : info.k[1]) != 0) return "its camera matrix has skew";
  return set_distortion(lens, model, is_rectified ? std::vector<double>() : info.d);
}

/// Whether images are as large as their calibration says, without a part cut out or pixels joined.
bool is_of_size(const ros::CameraInfo& info, int width_px, int height_px) {
  const ros::RegionOfInterest& part = info.roi;
  const bool is_whole = (part.width == 0 || part.width == info.width) &&
                        (part.height == 0 || part.height == info.height) && part.x_offset == 0 &&
                        part.y_offset == 0;
  return is_whole && info.binning_x <= 1 && info.binning_y <= 1 && std::cmp_equal(info.width, width_px) &&
         std::cmp_equal(info.height, height_px);
}

}  // namespace

std::optional<CameraIntrinsics> bag_lens(const ros::CameraInfo& info, const std::string& topic, int width_px,
                                         int height_px, Problem warning, Problems& warnings) {
  CameraDescription camera;
  std::string wrong = set_lens(info, topic.find("rect") != std::string::npos, camera.intrinsics);
  if (wrong.empty()) wrong = outside_ranges(camera);
  if (wrong.empty() && !is_of_size(info, width_px, height_px))
    wrong = fmt::format("it is for other images, of {} x {} pixels", info.width, info.height);
  if (wrong.empty()) return camera.intrinsics;
  warning.what = "its calibration is not taken: " + wrong;
  warnings.push_back(std::move(warning));
  return std::nullopt;
}

std::optional<CameraMount> bag_mount(const TransformTree& transforms, const std::string& base,
                                     const std::string& frame, Problem warning, Problems& warnings) {
  const auto warn = [&](std::string what) {
    warning.what = std::move(what);
    warnings.push_back(warning);
  };
  const auto T_base_camera = transforms.find(base, frame);
  if (frame == base || !T_base_camera) {
    warn(fmt::format("no fixed transforms lead from '{}' to '{}', so it is not known where the camera sits",
                     base, frame));
    return std::nullopt;
  }
  Mat3 R_base_camera = T_base_camera->linear();
  if (R_base_camera(2, 2) > kToTheSky) {
    R_base_camera = R_base_camera * CameraMount{}.R_vehicle_camera();
    warn(fmt::format("the z axis of '{}' looks up: taken for a frame whose x axis looks ahead", frame));
  }
  CameraDescription camera;
  camera.mount = mount_of(R_base_camera, T_base_camera->translation());
  if (const auto floor = transforms.frame_ending("base_footprint")) {
    if (const auto T_floor_camera = transforms.find(*floor, frame))
      camera.mount.p_vehicle_camera.z() = T_floor_camera->translation().z();
  }
  const std::string wrong = outside_ranges(camera);
  if (wrong.empty()) return camera.mount;
  warn("the camera's place by the transforms is not taken: " + wrong);
  return std::nullopt;
}

}  // namespace aisle
