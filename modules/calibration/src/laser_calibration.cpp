#include "aisle/calibration/laser_calibration.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"

namespace aisle {
namespace {

/// A point of the stripe in base_link, and how much height one pixel is there.
struct StripePoint {
  Vec3 p_vehicle;
  double height_by_row_m;
};

std::optional<Vec3> where_ray_meets(const TargetPlane& target, const CameraMount& mount,
                                    const Mat3& R_vehicle_camera, const PixelRay& ray) {
  const Vec3 direction = R_vehicle_camera * ray.direction;
  const double approach = target.normal.dot(direction);
  const double length = (target.offset_m - target.normal.dot(mount.p_vehicle_camera)) / approach;
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return mount.p_vehicle_camera + length * direction;
}

std::vector<StripePoint> stripe_points(std::span<const StripeView> views, const CameraModel& lens,
                                       const CameraMount& mount) {
  const Mat3 R_vehicle_camera = mount.R_vehicle_camera();
  std::vector<StripePoint> points;
  for (const StripeView& view : views) {
    for (const Vec2& pixel_px : view.points_px) {
      const auto ray = lens.ray(pixel_px), below = lens.ray(pixel_px + Vec2(0, 1));
      if (!ray || !below) continue;
      const auto p = where_ray_meets(view.target, mount, R_vehicle_camera, *ray);
      const auto q = where_ray_meets(view.target, mount, R_vehicle_camera, *below);
      if (p && q) points.push_back({*p, std::abs(p->z() - q->z())});
    }
  }
  return points;
}

/// Which slopes the points determine.
struct Unknowns {
  bool ahead = false, left = false;
};

Unknowns seen_slopes(const std::vector<StripePoint>& points) {
  const auto [near, far] =
      std::minmax_element(points.begin(), points.end(),
                          [](const auto& a, const auto& b) { return a.p_vehicle.x() < b.p_vehicle.x(); });
  const auto [right, left] =
      std::minmax_element(points.begin(), points.end(),
                          [](const auto& a, const auto& b) { return a.p_vehicle.y() < b.p_vehicle.y(); });
  const double reach_m = std::abs(far->p_vehicle.x());
  return {far->p_vehicle.x() - near->p_vehicle.x() > 0.2 * reach_m,
          left->p_vehicle.y() - right->p_vehicle.y() > 0.2 * reach_m};
}

/// A plane by least squares, with the covariance of its three values but for the points' variance.
struct PlaneFit {
  Vec3 values = Vec3::Zero();  ///< height, slope ahead, slope to the left
  Mat3 covariance = Mat3::Zero();

  double off(const StripePoint& point) const {
    return point.p_vehicle.z() - values.dot(Vec3(1, point.p_vehicle.x(), point.p_vehicle.y()));
  }
};

PlaneFit fit(const std::vector<StripePoint>& points, const std::vector<bool>& is_used,
             const Unknowns& unknowns) {
  Mat3 information = Mat3::Zero();
  Vec3 sums = Vec3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_used[i]) continue;
    const Vec3& p = points[i].p_vehicle;
    const Vec3 row{1, unknowns.ahead ? p.x() : 0, unknowns.left ? p.y() : 0};
    information += row * row.transpose();
    sums += row * p.z();
  }
  PlaneFit result;
  result.covariance = information.completeOrthogonalDecomposition().pseudoInverse();
  result.values = result.covariance * sums;
  return result;
}

/// The points that agree on one plane: starts at the median height and, round by round, takes the points near
/// the plane so far.
std::vector<bool> agreeing(const std::vector<StripePoint>& points, const Unknowns& unknowns) {
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const StripePoint& point : points) heights.push_back(point.p_vehicle.z());
  PlaneFit plane;
  plane.values[0] = median(heights);
  std::vector<bool> is_used(points.size());
  for (int round = 0; round < 10; ++round) {
    std::vector<double> distances;
    distances.reserve(points.size());
    for (const StripePoint& point : points) distances.push_back(std::abs(plane.off(point)));
    const double usual = median(distances);
    for (std::size_t i = 0; i < points.size(); ++i) {
      is_used[i] = distances[i] <= std::max(4 * usual, points[i].height_by_row_m);
    }
    plane = fit(points, is_used, unknowns);
  }
  return is_used;
}

}  // namespace

TargetPlane wall_ahead(double distance_m) {
  return {Vec3::UnitX(), distance_m};
}

TargetPlane plane_seen(const CameraMount& mount, const Vec3& p_camera, const Vec3& normal_camera) {
  const Mat3 R_vehicle_camera = mount.R_vehicle_camera();
  const Vec3 normal = R_vehicle_camera * normal_camera.normalized();
  return {normal, normal.dot(mount.p_vehicle_camera + R_vehicle_camera * p_camera)};
}

std::optional<LaserCalibration> calibrate_laser(std::span<const StripeView> views, const CameraModel& lens,
                                                const CameraMount& mount) {
  const std::vector<StripePoint> points = stripe_points(views, lens, mount);
  if (points.size() < kStripePointsMin) return std::nullopt;
  const Unknowns unknowns = seen_slopes(points);
  const std::vector<bool> is_used = agreeing(points, unknowns);
  const PlaneFit plane = fit(points, is_used, unknowns);

  LaserCalibration result;
  result.points_seen = points.size();
  double squares_m2 = 0, squares_px2 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_used[i]) continue;
    ++result.points;
    const double off_m = plane.off(points[i]);
    squares_m2 += off_m * off_m;
    squares_px2 += std::pow(off_m / points[i].height_by_row_m, 2);
  }
  if (result.points < kStripePointsMin || 2 * result.points < result.points_seen) return std::nullopt;
  const auto count = static_cast<double>(result.points);
  const Vec3 deviations = (squares_m2 / (count - 3) * plane.covariance.diagonal()).cwiseMax(0).cwiseSqrt();
  result.height_m = plane.values[0];
  result.slope_ahead = plane.values[1];
  result.slope_left = plane.values[2];
  result.height_deviation_m = deviations[0];
  result.slope_ahead_deviation = deviations[1];
  result.slope_left_deviation = deviations[2];
  result.rms_m = std::sqrt(squares_m2 / count);
  result.rms_px = std::sqrt(squares_px2 / count);
  result.verdict = judge(result);
  return result;
}

CalibrationVerdict judge(const LaserCalibration& c) {
  using enum CalibrationQuality;
  CalibrationVerdict verdict;
  if (c.height_m <= 0) verdict.limit(kPoor, "the plane lies below the floor: check mount and distances");
  if (c.height_deviation_m > 0.002) {
    verdict.limit(c.height_deviation_m > 0.01 ? kPoor : kUsable,
                  fmt::format("the height is known to {:.1f} mm only: more images, from nearer",
                              1000 * c.height_deviation_m));
  }
  const auto judge_slope = [&](const char* side, double slope, double deviation) {
    constexpr double kLevel = 0.2 * kDegree;
    if (std::abs(slope) < kLevel || std::abs(slope) < 3 * deviation) return;
    verdict.limit(kUsable,
                  fmt::format("the light plane is not level: it rises by {:.2f} deg to the {}; level "
                              "the laser, or distances will be wrong",
                              to_degrees(std::atan(slope)), side));
  };
  judge_slope("front", c.slope_ahead, c.slope_ahead_deviation);
  judge_slope("left", c.slope_left, c.slope_left_deviation);
  if (c.rms_px > 1) {
    verdict.limit(
        c.rms_px > 3 ? kPoor : kUsable,
        fmt::format("the stripe is {:.1f} px off a plane: is the target flat, its place right?", c.rms_px));
  }
  if (c.points < c.points_seen * 4 / 5) {
    verdict.limit(kUsable, fmt::format("{} of {} stripe points are something else", c.points_seen - c.points,
                                       c.points_seen));
  }
  return verdict;
}

}  // namespace aisle
