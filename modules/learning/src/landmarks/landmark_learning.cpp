#include "aisle/learning/landmarks/landmark_learning.hpp"

#include <algorithm>

namespace aisle {

namespace {

/// The landmark that one sighting shows.
Landmark as_seen(const LandmarkSighting& sighting, const Pose2& T_map_vehicle, double confidence_m2) {
  const Mat2 R_map_vehicle = rotation(T_map_vehicle.theta);
  return {.p_map = T_map_vehicle * sighting.p_vehicle,
          .covariance = R_map_vehicle * sighting.covariance * R_map_vehicle.transpose(),
          .mass = confidence_weight(sighting.p_vehicle, confidence_m2),
          .weight = confidence_weight(sighting.p_vehicle, confidence_m2),
          .sightings = 1,
          .passes = 1,
          .seen_from = (T_map_vehicle.position() - T_map_vehicle * sighting.p_vehicle).normalized(),
          .seen_near_m = sighting.p_vehicle.norm(),
          .seen_far_m = sighting.p_vehicle.norm(),
          .brighter_right = sighting.brighter_right};
}

}  // namespace

void LandmarkLearningParams::describe(FieldList& fields) {
  fields.group("localiser", localiser);
  fields.real("merge_m", merge_m, {0.01, 1}, "landmarks closer than this are merged");
  fields.real("weight_min", weight_min, {0, 1},
              "Ts: landmarks with less than this share of the mean weight are removed");
  fields.count("sightings_min", sightings_min, {1, 100},
               "landmarks seen in fewer images of the first run are removed");
  fields.flag("forget", forget, "landmarks that are no longer seen lose their weight");
  fields.flag("adjust", adjust, "adjust all poses and landmarks together until they agree best");
}

Landmark united(const Landmark& a, const Landmark& b) {
  Landmark both = a;
  both.mass = a.mass + b.mass;
  both.weight = a.weight + b.weight;
  both.p_map = (a.mass * a.p_map + b.mass * b.p_map) / both.mass;
  both.seen_from = (a.sightings * a.seen_from + b.sightings * b.seen_from).normalized();
  both.seen_near_m = std::min(a.seen_near_m, b.seen_near_m);
  both.seen_far_m = std::max(a.seen_far_m, b.seen_far_m);
  both.covariance = a.covariance.trace() < b.covariance.trace() ? a.covariance : b.covariance;
  both.sightings = a.sightings + b.sightings;
  return both;
}

std::vector<std::size_t> LandmarkLearner::merge(std::span<const LandmarkSighting> sightings,
                                                const Pose2& T_map_vehicle) {
  std::vector<std::size_t> into;
  std::vector<int> near;
  for (const LandmarkSighting& sighting : sightings) {
    Landmark landmark = as_seen(sighting, T_map_vehicle, params_.localiser.confidence_m2);
    map_.within(landmark.p_map, params_.merge_m, near);
    std::erase_if(near, [&](int i) {
      return params_.localiser.polarity &&
             map_[static_cast<std::size_t>(i)].brighter_right != landmark.brighter_right;
    });
    for (const int i : near) landmark = united(map_[static_cast<std::size_t>(i)], landmark);
    if (near.empty()) {
      into.push_back(map_.add(landmark));
      continue;
    }
    const auto kept = static_cast<std::size_t>(near.front());
    map_.replace(kept, landmark);
    for (std::size_t k = 1; k < near.size(); ++k) map_.remove(static_cast<std::size_t>(near[k]));
    into.push_back(kept);
  }
  return into;
}

void settle_weights(std::vector<Landmark>& landmarks, const Vec2& p_map_start, double weight_min) {
  if (landmarks.empty()) return;
  double sum = 0;
  for (const Landmark& landmark : landmarks) sum += landmark.mass;
  const double mean = sum / static_cast<double>(landmarks.size());
  for (Landmark& landmark : landmarks) landmark.weight = landmark.mass / mean;  // eq. (18)
  std::erase_if(landmarks, [&](const Landmark& landmark) { return landmark.weight < weight_min; });
  const auto by_weight = [](const Landmark& a, const Landmark& b) { return a.weight < b.weight; };
  const auto by_distance = [&](const Landmark& a, const Landmark& b) {
    return (a.p_map - p_map_start).squaredNorm() < (b.p_map - p_map_start).squaredNorm();
  };
  const double greatest = std::max_element(landmarks.begin(), landmarks.end(), by_weight)->weight;
  std::min_element(landmarks.begin(), landmarks.end(), by_distance)->weight = greatest;
}

}  // namespace aisle
