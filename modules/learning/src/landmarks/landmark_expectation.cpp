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
constexpr double kBeyond_m = 0.5;      // the farthest sighting its landmark may lie
constexpr double kFootFarthest_m = 7;  // feet farther away are vague

/// What landmarks look like from where the vehicle believes to be.
class BelievedSight {
 public:
  BelievedSight(const UncertainPose2& T_map_believed, double landmark_sigma_m)
      : T_vehicle_map_(T_map_believed.mean.inverse()),
        R_vehicle_map_(rotation(T_vehicle_map_.theta)),
        position_(T_map_believed.covariance.topLeftCorner<2, 2>()),
        heading_variance_(T_map_believed.covariance(2, 2)),
        place_variance_(square(landmark_sigma_m)) {}

  bool shows(const LandmarkSighting& seen, const Landmark& landmark) const {
    const Vec2 p_vehicle = T_vehicle_map_ * landmark.p_map;
    const Vec2 by_heading(p_vehicle.y(), -p_vehicle.x());
    const Mat2 covariance = seen.covariance + place_variance_ * Mat2::Identity() +
                            R_vehicle_map_ * (position_ + landmark.covariance) * R_vehicle_map_.transpose() +
                            heading_variance_ * by_heading * by_heading.transpose();
    const Vec2 off = seen.p_vehicle - p_vehicle;
    return seen.brighter_right == landmark.brighter_right &&
           off.dot(covariance.inverse() * off) < square(kSeenSigmas);
  }

 private:
  Pose2 T_vehicle_map_;
  Mat2 R_vehicle_map_, position_;
  double heading_variance_, place_variance_;
};

/// The landmarks that are there, up to a distance.
std::vector<int> sure_landmarks(const LandmarkMap& map, const Vec2& p_map_vehicle, double reach_m) {
  std::vector<int> near;
  map.within(p_map_vehicle, reach_m, near);
  near.erase(std::remove_if(near.begin(), near.end(),
                            [&](int i) { return map[static_cast<std::size_t>(i)].weight < kExpectedWeight; }),
             near.end());
  return near;
}

}  // namespace

std::vector<ExpectedLandmark> expected_landmarks(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                                                 std::span<const LandmarkSighting> picture,
                                                 double landmark_sigma_m) {
  const Pose2& T_map_vehicle = T_map_believed.mean;
  const LandmarkView view(picture);
  const BelievedSight sight(T_map_believed, landmark_sigma_m);
  std::vector<ExpectedLandmark> expected;
  for (const int i : sure_landmarks(map, T_map_vehicle.position(), view.far_m())) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    if (!view.expects(landmark, T_map_vehicle)) continue;
    expected.push_back({i, std::any_of(picture.begin(), picture.end(), [&](const LandmarkSighting& seen) {
                          return sight.shows(seen, landmark);
                        })});
  }
  return expected;
}

std::size_t known_sightings(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                            std::span<const LandmarkSighting> picture, double landmark_sigma_m) {
  const BelievedSight sight(T_map_believed, landmark_sigma_m);
  const std::vector<int> near =
      sure_landmarks(map, T_map_believed.mean.position(), LandmarkView(picture).far_m() + kBeyond_m);
  return static_cast<std::size_t>(
      std::count_if(picture.begin(), picture.end(), [&](const LandmarkSighting& seen) {
        return std::any_of(near.begin(), near.end(),
                           [&](int i) { return sight.shows(seen, map[static_cast<std::size_t>(i)]); });
      }));
}

std::size_t landmarks_in_picture(const LandmarkMap& map, const Pose2& T_map_vehicle,
                                 const FloorInPicture& floor) {
  const std::vector<int> near = sure_landmarks(map, T_map_vehicle.position(), kFootFarthest_m);
  return static_cast<std::size_t>(std::count_if(near.begin(), near.end(), [&](int i) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    return floor.shows(T_map_vehicle.inverse() * landmark.p_map) &&
           was_seen_from_about(landmark, T_map_vehicle.position());
  }));
}

}  // namespace aisle
