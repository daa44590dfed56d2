#include "aisle/vision/landmark_sightings.hpp"

namespace aisle {

namespace {

/// Where a ray from `origin` in `direction` meets a polyline.
std::optional<Vec2> meeting(const Vec2& origin, const Vec2& direction, const std::vector<Vec2>& polyline) {
  const Vec2 across = left_normal(direction);
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const double from = across.dot(polyline[i - 1] - origin), to = across.dot(polyline[i] - origin);
    if ((from < 0) == (to < 0)) continue;
    const Vec2 point = polyline[i - 1] + from / (from - to) * (polyline[i] - polyline[i - 1]);
    if (direction.dot(point - origin) > 0) return point;
  }
  return std::nullopt;
}

CameraMount tilted(CameraMount mount, double by_rad) {
  mount.tilt_rad += by_rad;
  return mount;
}

}  // namespace

void LandmarkSightingParams::describe(FieldList& fields) {
  fields.group("verticals", verticals);
  fields.group("base_lines", base_lines);
  fields.group("noise", noise);
  fields.real("distance_max_m", distance_max_m, {1, 50}, "feet farther away are not used");
  fields.flag("hanging", hanging, "use lines that end above the floor, such as a poster's edges");
}

LandmarkDetector::LandmarkDetector(const LandmarkSightingParams& params, const CameraIntrinsics& intrinsics,
                                   const CameraMount& mount)
    : params_(params),
      camera_(intrinsics),
      mount_(mount),
      floor_(camera_, mount, 0),
      floor_tilted_(camera_, tilted(mount, params.noise.tilt_rad), 0),
      verticals_(params.verticals, camera_),
      base_line_detector_(params.base_lines, camera_) {}

const std::vector<LandmarkSighting>& LandmarkDetector::detect(const Image& grey) {
  lines_ = verticals_.detect(grey);
  base_lines_ = base_line_detector_.detect(grey, lines_);
  stand_on_floor(grey, base_lines_, params_.base_lines, lines_);
  back_project(base_lines_.left, left_wall_vehicle_);
  back_project(base_lines_.right, right_wall_vehicle_);
  sightings_.clear();
  for (const VerticalLine& line : lines_) {
    const auto pixel_px = foot_px(line);
    if (!pixel_px) continue;
    const auto foot = floor_.uncertain_point(*pixel_px, params_.noise);
    const auto tilted_foot = floor_tilted_.point(*pixel_px);
    if (!foot || !tilted_foot || foot->mean.norm() > params_.distance_max_m) continue;
    sightings_.push_back({.p_vehicle = foot->mean,
                          .covariance = foot->covariance,
                          .by_tilt = *tilted_foot - foot->mean,
                          .foot_px = *pixel_px,
                          .brighter_right = line.contrast > 0});
  }
  return sightings_;
}

void LandmarkDetector::back_project(const std::optional<BaseLine>& base_line,
                                    std::vector<Vec2>& wall_vehicle) const {
  wall_vehicle.clear();
  if (!base_line) return;
  for (const Vec2& pixel_px : *base_line) {
    if (const auto point = floor_.point(pixel_px)) wall_vehicle.push_back(*point);
  }
}

std::optional<Vec2> LandmarkDetector::foot_px(const VerticalLine& line) const {
  if (line.foot) return line.bottom_px;
  if (!params_.hanging) return std::nullopt;
  if (const auto left = hanging_foot(line, left_wall_vehicle_)) return left;
  return hanging_foot(line, right_wall_vehicle_);
}

std::optional<Vec2> LandmarkDetector::hanging_foot(const VerticalLine& line,
                                                   const std::vector<Vec2>& wall_vehicle) const {
  const auto middle = camera_.ray((line.top_px + line.bottom_px) / 2);
  if (!middle) return std::nullopt;
  const Vec3 ray = mount_.R_vehicle_camera() * middle->direction;
  const auto foot = meeting(mount_.p_vehicle_camera.head<2>(), ray.head<2>(), wall_vehicle);
  if (!foot) return std::nullopt;
  const auto pixel_px = camera_.project(mount_.to_camera({foot->x(), foot->y(), 0}));
  if (!pixel_px || pixel_px->y() < line.bottom_px.y()) return std::nullopt;
  return pixel_px;
}

}  // namespace aisle
