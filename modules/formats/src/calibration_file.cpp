#include "aisle/formats/calibration_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/formats/whole_file.hpp"
#include "calibration_lens.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr double kCoefficientMax = 1e4;

using Names = std::initializer_list<const char*>;
constexpr Names kMatrixNames = {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "M1", "intrinsics"};
constexpr Names kDistortionNames = {"distortion_coefficients",
                                    "Distortion_Coefficients",
                                    "distCoeffs",
                                    "dist_coeffs",
                                    "distortion_coeffs",
                                    "D",
                                    "D1"};
constexpr Names kRmsNames = {"rms", "avg_reprojection_error", "Avg_Reprojection_Error"};

/// OpenCV's files start with "%YAML:1.0", which is not a YAML directive. The line becomes a comment.
std::string without_opencv_head(std::string_view text) {
  std::string yaml(text);
  if (yaml.starts_with("%YAML:")) yaml[0] = '#';
  return yaml;
}

/// A value and the key under which it was found.
struct Entry {
  std::string key;
  YAML::Node node;
};

/// Reads one document; collects all problems instead of stopping at the first.
class CalibrationReader {
 public:
  explicit CalibrationReader(const std::string& file) : file_(file), problems_(file) {}

  Result<CameraCalibration> read(std::string_view text) {
    try {
      read_document(load_yaml(without_opencv_head(text)));
    } catch (const YAML::Exception& error) {
      return Problem{{file_, error.mark.line + 1}, "is not YAML: " + error.msg};
    }
    if (!problems_.empty()) return problems_.take();
    return calibration_;
  }

 private:
  void read_document(const YAML::Node& document);
  static std::vector<std::string> kalibr_cameras(const YAML::Node& document);
  void read_camera(const YAML::Node& document);
  void set_name(const Entry& entry, const std::string& name);
  void read_size(const YAML::Node& document);
  void read_matrix(const Entry& entry);
  void read_distortion(const Entry& entry, std::optional<LensModel> model);
  std::optional<LensModel> read_model(const YAML::Node& document);
  void read_mount(const YAML::Node& node);

  std::optional<Entry> first_of(const YAML::Node& document, Names names);
  std::vector<double> numbers(const Entry& entry, double limit);
  std::optional<double> number(const Entry& entry, Range range);
  void side(const Entry& entry, int& side_px);
  void problem(const YAML::Node& node, const std::string& key, std::string what) {
    problems_.add(std::max(0, node.Mark().line) + 1, key, std::move(what));
  }

  std::string file_;
  ProblemList problems_;
  CameraCalibration calibration_;
};

void CalibrationReader::read_document(const YAML::Node& document) {
  if (!document.IsMap()) {
    problem(document, "", "is not a calibration: expected keys such as camera_matrix");
    return;
  }
  add_duplicate_keys(document, problems_);
  if (const std::vector<std::string> cameras = kalibr_cameras(document); !cameras.empty()) {
    if (cameras.size() > 1) {
      return problem(document, "",
                     fmt::format("has the cameras {}; leave only the one that is meant in the file",
                                 printable(fmt::format("{}", fmt::join(cameras, ", ")))));
    }
    read_camera(document[cameras.front()]);
    return set_name({"", document}, cameras.front());
  }
  read_camera(document);
}

/// kalibr's camchain has one map a camera: cam0, cam1 ...
std::vector<std::string> CalibrationReader::kalibr_cameras(const YAML::Node& document) {
  std::vector<std::string> cameras;
  for (const auto& entry : document) {
    if (entry.first.IsScalar() && entry.second.IsMap() && entry.second["intrinsics"])
      cameras.push_back(entry.first.Scalar());
  }
  return cameras;
}

void CalibrationReader::read_camera(const YAML::Node& document) {
  const std::optional<LensModel> model = read_model(document);
  read_size(document);
  if (const auto entry = first_of(document, kMatrixNames)) {
    read_matrix(*entry);
  } else {
    problem(document, "camera_matrix", "is missing");
  }
  calibration_.intrinsics.model = model.value_or(LensModel::kPlumbBob);
  if (const auto entry = first_of(document, kDistortionNames)) read_distortion(*entry, model);
  if (const auto entry = first_of(document, {"camera_name"}); entry && entry->node.IsScalar())
    set_name(*entry, entry->node.Scalar());
  if (const auto entry = first_of(document, kRmsNames)) calibration_.rms_px = number(*entry, {0, 1e6});
  if (const auto entry = first_of(document, {"vehicle_mount"})) read_mount(entry->node);
  if (const auto entry = first_of(document, {"laser_height_m"})) {
    calibration_.laser_height_m = number(*entry, {0, 10});
  }
}

void CalibrationReader::set_name(const Entry& entry, const std::string& name) {
  calibration_.camera_name = name;
  if (!is_line_of_text(name)) problem(entry.node, entry.key, "is not a line of UTF-8 text");
}

/// The lens model that the file states; refuses one that CameraModel does not have.
std::optional<LensModel> CalibrationReader::read_model(const YAML::Node& document) {
  std::optional<LensModel> model;
  const auto state = [&](const Entry& entry, LensModel stated) {
    if (model && *model != stated)
      problem(entry.node, entry.key,
              fmt::format("says {}, but the file also says {}", name_of(stated), name_of(*model)));
    model = stated;
  };
  for (const char* key : {"distortion_model", "camera_model"}) {
    const auto entry = first_of(document, {key});
    if (!entry) continue;
    const std::string name = entry->node.IsScalar() ? entry->node.Scalar() : "no single value";
    if (entry->key == "camera_model" && name == "pinhole") continue;
    if (const auto named = lens_model_named(name)) {
      state(*entry, *named);
      continue;
    }
    problem(entry->node, entry->key,
            fmt::format("'{}' is none of plumb_bob (radtan), rational_polynomial, equidistant (fisheye)",
                        printable(name)));
  }
  if (const auto fisheye = first_of(document, {"fisheye_model"})) {
    if (number(*fisheye, {0, 1}).value_or(0) != 0) state(*fisheye, LensModel::kEquidistant);
  }
  return model;
}

void CalibrationReader::read_size(const YAML::Node& document) {
  if (const YAML::Node size = document["resolution"]; size && size.IsSequence() && size.size() == 2) {
    side({"resolution[0]", size[0]}, calibration_.width_px);
    side({"resolution[1]", size[1]}, calibration_.height_px);
  }
  if (const auto width = first_of(document, {"image_width"})) side(*width, calibration_.width_px);
  if (const auto height = first_of(document, {"image_height"})) side(*height, calibration_.height_px);
  if ((calibration_.width_px == 0) != (calibration_.height_px == 0) && problems_.empty()) {
    problem(document, calibration_.width_px == 0 ? "image_width" : "image_height",
            "is missing, though the other side is given");
  }
}

void CalibrationReader::side(const Entry& entry, int& side_px) {
  const auto value = number(entry, {1, kImageSideMax_px});
  if (!value) return;
  if (*value != std::floor(*value)) problem(entry.node, entry.key, "is not a whole number");
  side_px = static_cast<int>(*value);
}

/// The camera matrix, or kalibr's [fx, fy, cx, cy].
void CalibrationReader::read_matrix(const Entry& entry) {
  const std::vector<double> m = numbers(entry, 1e6);
  const bool is_short = entry.key == "intrinsics";
  if (m.empty()) return;
  if (m.size() != (is_short ? 4 : 9)) {
    problem(entry.node, entry.key,
            is_short ? "is not [fx, fy, cx, cy]"
                     : fmt::format("has {} numbers, not the 9 of a camera matrix", m.size()));
    return;
  }
  CameraIntrinsics& lens = calibration_.intrinsics;
  lens.fx_px = m[0], lens.fy_px = m[is_short ? 1 : 4], lens.cx_px = m[2], lens.cy_px = m[is_short ? 3 : 5];
  if (lens.fx_px <= 0 || lens.fy_px <= 0)
    problem(entry.node, entry.key, "the focal lengths are not positive");
  if (is_short) return;
  if (m[1] != 0) problem(entry.node, entry.key, "skew is not supported: the second number must be 0");
  if (m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
    problem(entry.node, entry.key, "is not [fx, 0, cx, 0, fy, cy, 0, 0, 1]");
}

void CalibrationReader::read_distortion(const Entry& entry, std::optional<LensModel> model) {
  const std::string wrong = set_distortion(calibration_.intrinsics, model, numbers(entry, kCoefficientMax));
  if (!wrong.empty()) problem(entry.node, entry.key, wrong);
}

void CalibrationReader::read_mount(const YAML::Node& node) {
  if (!node.IsMap()) {
    problem(node, "vehicle_mount", "is not a map of x_m, y_m, z_m, tilt_deg, pan_deg, roll_deg");
    return;
  }
  struct Value {
    const char* key;
    double* target;
    double unit;
    Range range;
  };
  CameraMount mount;
  const std::array<Value, 6> values = {{{"x_m", &mount.p_vehicle_camera.x(), 1, {-10, 10}},
                                        {"y_m", &mount.p_vehicle_camera.y(), 1, {-10, 10}},
                                        {"z_m", &mount.p_vehicle_camera.z(), 1, {0, 10}},
                                        {"tilt_deg", &mount.tilt_rad, kDegree, {-90, 90}},
                                        {"pan_deg", &mount.pan_rad, kDegree, {-180, 180}},
                                        {"roll_deg", &mount.roll_rad, kDegree, {-180, 180}}}};
  for (const Value& value : values) {
    const std::string key = std::string("vehicle_mount.") + value.key;
    const YAML::Node entry = node[value.key];
    if (!entry) {
      problem(node, key, "is missing");
    } else if (const auto read = number({key, entry}, value.range)) {
      *value.target = *read * value.unit;
    }
  }
  if (node.size() != values.size() && problems_.empty()) {
    problem(node, "vehicle_mount", "has more keys than x_m, y_m, z_m, tilt_deg, pan_deg, roll_deg");
  }
  calibration_.mount = mount;
}

std::optional<Entry> CalibrationReader::first_of(const YAML::Node& document, Names names) {
  for (const char* name : names) {
    if (const YAML::Node node = document[name]) return Entry{name, node};
  }
  return std::nullopt;
}

/// The numbers of a matrix, {rows, cols, data} or a plain list; empty if unreadable.
std::vector<double> CalibrationReader::numbers(const Entry& entry, double limit) {
  constexpr std::size_t kNumbersMax = 16;
  const YAML::Node list = entry.node.IsMap() ? entry.node["data"] : entry.node;
  if (!list || !list.IsSequence() || list.size() > kNumbersMax) {
    problem(entry.node, entry.key, fmt::format("is not a list of at most {} numbers", kNumbersMax));
    return {};
  }
  std::vector<double> read;
  for (const YAML::Node& node : list) {
    const auto value = number({entry.key, node}, {-limit, limit});
    if (!value) return {};
    read.push_back(*value);
  }
  return read;
}

std::optional<double> CalibrationReader::number(const Entry& entry, Range range) {
  const std::string text = entry.node.IsScalar() ? entry.node.Scalar() : "no single value";
  const std::optional<double> value = parse_number(text);
  if (!value || !std::isfinite(*value)) {
    problem(entry.node, entry.key, fmt::format("'{}' is not a number", printable(text)));
    return std::nullopt;
  }
  if (*value < range.min || *value > range.max) {
    problem(entry.node, entry.key,
            fmt::format("{} is outside {:g} .. {:g}", printable(text), range.min, range.max));
    return std::nullopt;
  }
  return value;
}

}  // namespace

Result<CameraCalibration> read_calibration(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_calibration(*text, path.string());
}

Result<CameraCalibration> parse_calibration(std::string_view text, const std::string& name) {
  return CalibrationReader(name).read(text);
}

}  // namespace aisle
