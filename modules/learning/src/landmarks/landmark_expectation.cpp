#include "aisle/learning/landmarks/landmark_expectation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "aisle/core/square.hpp"
#include "landmarks/landmark_view.hpp"

namespace aisle {
namespace {

constexpr double kExpectedWeight = 0.5;  // landmarks of this weight are there
constexpr double kSeenSigmas = 2;
constexpr double kBeyond_m = 0.5;  // the farthest sighting its landmark may lie

}  // namespace

std::vector<ExpectedLandmark> expected_landmarks(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                                 std::span<const LandmarkSighting> picture,
                                                 double landmark_sigma_m) {
  const Pose2& T_map_vehicle = T_map_believed.mean;
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  const Mat2 R_vehicle_map = rotation(T_vehicle_map.theta);
  const Mat2 position = T_map_believed.covariance.topLeftCorner<2, 2>();
  const LandmarkView view(picture);
  std::vector<ExpectedLandmark> expected;
  std::vector<int> near;
  map.within(T_map_vehicle.position(), view.far_m() + kBeyond_m, near);
  for (const int i : near) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    if (landmark.weight < kExpectedWeight || !was_seen_from_about(landmark, T_map_vehicle.position()))
      continue;
    const Vec2 p_vehicle = T_vehicle_map * landmark.p_map;
    const Vec2 by_heading(p_vehicle.y(), -p_vehicle.x());
    const Mat2 known = R_vehicle_map * (position + landmark.covariance) * R_vehicle_map.transpose() +
                       T_map_believed.covariance(2, 2) * by_heading * by_heading.transpose() +
                       square(landmark_sigma_m) * Mat2::Identity();
    const auto shows_it = [&](const LandmarkSighting& seen) {
      const Vec2 off = seen.p_vehicle - p_vehicle;
      return seen.brighter_right == landmark.brighter_right &&
             off.dot((seen.covariance + known).inverse() * off) < square(kSeenSigmas);
    };
    const bool is_seen = std::any_of(picture.begin(), picture.end(), shows_it);
    if (is_seen || view.covers(p_vehicle)) expected.push_back({i, is_seen});
  }
  return expected;
}

}  // namespace aisle
