#include "aisle/vehicle/same_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace aisle {
namespace {

/// How far a field may be from what it was, in the key's unit.
struct Tolerance {
  const char* key;
  double absolute = 0;
  double relative = 0;
};

constexpr std::array kTolerances = {
    Tolerance{.key = "width_px"},
    Tolerance{.key = "height_px"},
    Tolerance{.key = "fx_px", .relative = 0.005},
    Tolerance{.key = "fy_px", .relative = 0.005},
    Tolerance{.key = "cx_px", .absolute = 0.5},
    Tolerance{.key = "cy_px", .absolute = 0.5},
    Tolerance{.key = "x_m", .absolute = 0.005},
    Tolerance{.key = "y_m", .absolute = 0.005},
    Tolerance{.key = "z_m", .absolute = 0.005},
    Tolerance{.key = "tilt_deg", .absolute = 0.2},
    Tolerance{.key = "pan_deg", .absolute = 0.2},
    Tolerance{.key = "roll_deg", .absolute = 0.2},
};
constexpr double kDistortion_px = 0.5;
constexpr double kRounding = 1e-9;  // a value on the edge of a tolerance is within it

double value_of(const Field& field) {
  if (const auto* count = std::get_if<int*>(&field.target)) return **count;
  return *std::get<double*>(field.target);
}

double difference(const Field& learned, const Field& present) {
  const bool is_angle = learned.inner_unit != 1;
  const double difference = value_of(present) - value_of(learned);
  return is_angle ? std::abs(to_degrees(wrap_angle(difference))) : std::abs(difference);
}

bool agrees(const Field& learned, const Field& present) {
  const auto* tolerance = std::find_if(kTolerances.begin(), kTolerances.end(),
                                       [&](const Tolerance& t) { return learned.key == t.key; });
  if (tolerance == kTolerances.end()) return true;
  const double allowed = tolerance->absolute + tolerance->relative * std::abs(value_of(learned));
  return difference(learned, present) <= allowed + kRounding;
}

/// How far a lens moves what another one shows at a pixel, not counting focal lengths and optical axis.
double distortion_difference_px(const CameraIntrinsics& learned, CameraIntrinsics other,
                                const Vec2& pixel_px) {
  other.fx_px = learned.fx_px;
  other.fy_px = learned.fy_px;
  other.cx_px = learned.cx_px;
  other.cy_px = learned.cy_px;
  const auto ray = CameraModel(learned).ray(pixel_px);
  if (!ray) return 0;
  const auto moved_px = CameraModel(other).project(ray->direction);
  return moved_px ? (*moved_px - pixel_px).norm() : std::numeric_limits<double>::infinity();
}

/// The most over corners, edges and inside of the image.
double distortion_difference_px(const CameraDescription& learned, const CameraDescription& present) {
  constexpr int kSteps = 8;
  double most_px = 0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Vec2 pixel_px((learned.width_px - 1) * i / double{kSteps},
                          (learned.height_px - 1) * j / double{kSteps});
      most_px = std::max(most_px, distortion_difference_px(learned.intrinsics, present.intrinsics, pixel_px));
    }
  }
  return most_px;
}

}  // namespace

Problems check_same_camera(const CameraDescription& learned, const CameraDescription& present) {
  const std::string camera = "cameras." + present.name;
  Problems problems;
  if (learned.name != present.name)
    problems.push_back(
        {{"", 0, camera}, fmt::format("is not '{}', which the landmarks were seen with", learned.name)});
  CameraDescription before = learned, now = present;
  const FieldList before_fields = fields_of(before), now_fields = fields_of(now);
  for (std::size_t i = 0; i < now_fields.all().size(); ++i) {
    const Field &was = before_fields.all()[i], &is = now_fields.all()[i];
    if (agrees(was, is)) continue;
    problems.push_back(
        {{"", 0, camera + "." + is.key},
         fmt::format("is {}, but the landmarks were seen with {}", is.value_text(), was.value_text())});
  }
  const double distortion_px = distortion_difference_px(learned, present);
  if (distortion_px > kDistortion_px) {
    problems.push_back(
        {{"", 0, camera + ".k1"},
         fmt::format("and the further distortion differ by {:.1f} px from the lens that the landmarks "
                     "were seen with",
                     distortion_px)});
  }
  return problems;
}

}  // namespace aisle
