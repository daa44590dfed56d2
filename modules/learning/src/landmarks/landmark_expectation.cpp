#include "aisle/learning/landmarks/landmark_expectation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "aisle/core/square.hpp"
#include "landmarks/landmark_view.hpp"

namespace aisle {
namespace {

constexpr double kExpectedWeight = 0.5;  // landmarks of this weight surely exist
constexpr double kSeenSigmas = 2;
constexpr double kBeyond_m = 0.5;  // greatest distance of a sighting from its landmark

/// A landmark as it should appear from the believed pose.
struct BelievedSight {
  Vec2 p_vehicle;
  Mat2 covariance;
  bool brighter_right;

  bool is_shown_by(const LandmarkSighting& seen) const {
    const Vec2 off = seen.p_vehicle - p_vehicle;
    return seen.brighter_right == brighter_right &&
           off.dot((seen.covariance + covariance).inverse() * off) < square(kSeenSigmas);
  }
};

BelievedSight sight_of(const Landmark& landmark, const UncertainPose2& T_map_believed,
                       double landmark_sigma_m) {
  const Pose2 T_vehicle_map = T_map_believed.mean.inverse();
  const Mat2 R_vehicle_map = rotation(T_vehicle_map.theta);
  const Mat2 position = T_map_believed.covariance.topLeftCorner<2, 2>();
  const Vec2 p_vehicle = T_vehicle_map * landmark.p_map;
  const Vec2 by_heading(p_vehicle.y(), -p_vehicle.x());
  return {p_vehicle,
          R_vehicle_map * (position + landmark.covariance) * R_vehicle_map.transpose() +
              T_map_believed.covariance(2, 2) * by_heading * by_heading.transpose() +
              square(landmark_sigma_m) * Mat2::Identity(),
          landmark.brighter_right};
}

/// The sure landmarks within a distance.
std::vector<int> sure_landmarks(const LandmarkMap& map, const Vec2& p_map_vehicle, double reach_m) {
  std::vector<int> near;
  map.within(p_map_vehicle, reach_m, near);
  std::erase_if(near, [&](int i) { return map[static_cast<std::size_t>(i)].weight < kExpectedWeight; });
  return near;
}

}  // namespace

std::vector<ExpectedLandmark> expected_landmarks(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                                 std::span<const LandmarkSighting> image,
                                                 double landmark_sigma_m) {
  const Pose2& T_map_vehicle = T_map_believed.mean;
  const LandmarkView view(image);
  std::vector<ExpectedLandmark> expected;
  for (const int i : sure_landmarks(map, T_map_vehicle.position(), view.far_m())) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    if (!view.expects(landmark, T_map_vehicle)) continue;
    const BelievedSight sight = sight_of(landmark, T_map_believed, landmark_sigma_m);
    const auto shows_it = [&](const LandmarkSighting& seen) { return sight.is_shown_by(seen); };
    expected.push_back({i, std::any_of(image.begin(), image.end(), shows_it)});
  }
  return expected;
}

std::size_t known_sightings(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                            std::span<const LandmarkSighting> image, double landmark_sigma_m) {
  std::vector<BelievedSight> sights;
  for (const int i :
       sure_landmarks(map, T_map_believed.mean.position(), LandmarkView(image).far_m() + kBeyond_m))
    sights.push_back(sight_of(map[static_cast<std::size_t>(i)], T_map_believed, landmark_sigma_m));
  const auto is_known = [&](const LandmarkSighting& seen) {
    return std::any_of(sights.begin(), sights.end(),
                       [&](const BelievedSight& sight) { return sight.is_shown_by(seen); });
  };
  return static_cast<std::size_t>(std::count_if(image.begin(), image.end(), is_known));
}

std::size_t landmarks_in_image(const LandmarkMap& map, const Pose2& T_map_vehicle,
                               const FloorInImage& floor) {
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  const std::vector<int> near = sure_landmarks(map, T_map_vehicle.position(), kFloorPointFarthest_m);
  return static_cast<std::size_t>(std::count_if(near.begin(), near.end(), [&](int i) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    return floor.shows(T_vehicle_map * landmark.p_map) &&
           was_seen_from_about(landmark, T_map_vehicle.position());
  }));
}

}  // namespace aisle
