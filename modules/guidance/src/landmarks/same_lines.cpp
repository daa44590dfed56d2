#include "landmarks/same_lines.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kSameLineSigmas = 3.5;
constexpr double kMovedSigma_m = 0.03;  // of the odometry between two images

bool is_of_one_line(const LandmarkSighting& a, const LandmarkSighting& b) {
  if (a.brighter_right != b.brighter_right) return false;
  const Mat2 covariance = a.covariance + b.covariance + square(kMovedSigma_m) * Mat2::Identity();
  const Vec2 off = a.p_vehicle - b.p_vehicle;
  return off.dot(covariance.inverse() * off) < square(kSameLineSigmas);
}

}  // namespace

bool shows(std::span<const LandmarkSighting> image, const LandmarkSighting& line) {
  return std::any_of(image.begin(), image.end(),
                     [&](const LandmarkSighting& seen) { return is_of_one_line(seen, line); });
}

double shown_share(std::span<const LandmarkSighting> image, std::span<const LandmarkSighting> other) {
  const auto shown = std::count_if(image.begin(), image.end(),
                                   [&](const LandmarkSighting& line) { return shows(other, line); });
  return static_cast<double>(shown) / static_cast<double>(image.size());
}

void carry_sightings(std::vector<LandmarkSighting>& scene, const Pose2& T_now_before) {
  const Mat2 R_now_before = rotation(T_now_before.theta);
  for (LandmarkSighting& sighting : scene) {
    sighting.p_vehicle = T_now_before * sighting.p_vehicle;
    sighting.covariance = R_now_before * sighting.covariance * R_now_before.transpose();
  }
}

}  // namespace aisle
