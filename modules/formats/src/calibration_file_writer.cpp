#include <fmt/format.h>

#include "aisle/core/angle.hpp"
#include "aisle/formats/calibration_file.hpp"
#include "calibration_lens.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

std::string size_text(const CameraCalibration& c) {
  if (c.width_px == 0) return "";
  return fmt::format("image_width: {}\nimage_height: {}\n", c.width_px, c.height_px);
}

std::string matrix_data(const CameraIntrinsics& lens) {
  return fmt::format("[{}, 0., {}, 0., {}, {}, 0., 0., 1.]", lens.fx_px, lens.cx_px, lens.fy_px, lens.cy_px);
}

std::string distortion_data(const std::vector<double>& coefficients) {
  return fmt::format("[{}]", fmt::join(coefficients, ", "));
}

/// Keys that neither OpenCV nor ROS defines; both ignore them.
std::string own_keys(const CameraCalibration& c) {
  std::string text;
  if (c.rms_px) text += fmt::format("rms: {:.4g}\n", *c.rms_px);
  if (c.mount) {
    const auto degrees = [](double angle_rad) { return fmt::format("{:.9g}", to_degrees(angle_rad)); };
    const Vec3& p = c.mount->p_vehicle_camera;
    text += fmt::format(
        "vehicle_mount:\n"
        "   x_m: {:.9g}\n   y_m: {:.9g}\n   z_m: {:.9g}\n"
        "   tilt_deg: {}\n   pan_deg: {}\n   roll_deg: {}\n",
        p.x(), p.y(), p.z(), degrees(c.mount->tilt_rad), degrees(c.mount->pan_rad),
        degrees(c.mount->roll_rad));
  }
  if (c.laser_height_m) text += fmt::format("laser_height_m: {:.9g}\n", *c.laser_height_m);
  return text;
}

}  // namespace

std::string opencv_calibration_yaml(const CameraCalibration& c) {
  const auto matrix = [](const char* key, int rows, int cols, const std::string& data) {
    return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: {}\n", key, rows,
                       cols, data);
  };
  const std::vector<double> distortion = distortion_coefficients(c.intrinsics);
  return "%YAML:1.0\n---\n" + size_text(c) + "camera_name: " + yaml_quoted(c.camera_name) + "\n" +
         matrix("camera_matrix", 3, 3, matrix_data(c.intrinsics)) +
         (c.intrinsics.model == LensModel::kEquidistant ? "fisheye_model: 1\n" : "") +
         matrix("distortion_coefficients", static_cast<int>(distortion.size()), 1,
                distortion_data(distortion)) +
         own_keys(c);
}

std::string camera_info_yaml(const CameraCalibration& c) {
  const auto matrix = [](const char* key, int rows, int cols, const std::string& data) {
    return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: {}\n", key, rows, cols, data);
  };
  const CameraIntrinsics& lens = c.intrinsics;
  const std::vector<double> distortion = distortion_coefficients(lens);
  return size_text(c) + "camera_name: " + yaml_quoted(c.camera_name) + "\n" +
         matrix("camera_matrix", 3, 3, matrix_data(lens)) + "distortion_model: " + name_of(lens.model) +
         "\n" +
         matrix("distortion_coefficients", 1, static_cast<int>(distortion.size()),
                distortion_data(distortion)) +
         matrix("rectification_matrix", 3, 3, "[1., 0., 0., 0., 1., 0., 0., 0., 1.]") +
         matrix("projection_matrix", 3, 4,
                fmt::format("[{}, 0., {}, 0., 0., {}, {}, 0., 0., 0., 1., 0.]", lens.fx_px, lens.cx_px,
                            lens.fy_px, lens.cy_px)) +
         own_keys(c);
}

}  // namespace aisle
