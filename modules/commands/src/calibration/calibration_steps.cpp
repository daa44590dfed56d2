#include "calibration/calibration_steps.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "aisle/formats/calibration_file.hpp"
#include "aisle/formats/images/image_file.hpp"

namespace aisle {

double nine_digits(double value) {
  return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

nlohmann::ordered_json verdict_figures(const CalibrationVerdict& verdict) {
  return {{"quality", to_string(verdict.quality)}, {"reasons", verdict.reasons}};
}

std::string verdict_text(const CalibrationVerdict& verdict) {
  std::string text = fmt::format("verdict: {}\n", to_string(verdict.quality));
  for (const std::string& reason : verdict.reasons) text += "  - " + reason + "\n";
  return text;
}

Result<Image> read_calibrated_image(const std::filesystem::path& path, const CameraCalibration& calibration) {
  Result<Image> image = read_image(path);
  if (!image || calibration.width_px == 0) return image;
  if (image->width_px != calibration.width_px || image->height_px != calibration.height_px) {
    return Problem{{path.string()},
                   fmt::format("has {} x {} pixels; the calibration is for {} x {}", image->width_px,
                               image->height_px, calibration.width_px, calibration.height_px)};
  }
  return image;
}

Result<std::optional<OutputDirectory>> open_calibration_directory(const std::filesystem::path& directory,
                                                                  bool force, bool with_residuals) {
  std::vector<std::string> names = {"camera.yaml", "camera_info.yaml"};
  if (with_residuals) names.insert(names.end(), {"residuals.svg", "residuals.png"});
  return OutputDirectory::open_if_named(directory, force, names);
}

std::vector<OutputFile> calibration_files(const CameraCalibration& calibration,
                                          const std::optional<ResidualPicture>& residuals) {
  std::vector<OutputFile> files = {{"calibration", "camera.yaml", opencv_calibration_yaml(calibration)},
                                   {"camera_info", "camera_info.yaml", camera_info_yaml(calibration)}};
  if (residuals) {
    files.push_back({"residuals_svg", "residuals.svg", svg(*residuals)});
    files.push_back({"residuals_png", "residuals.png", png(*residuals)});
  }
  return files;
}

}  // namespace aisle
