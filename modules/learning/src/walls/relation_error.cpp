#include "aisle/learning/walls/relation_error.hpp"

#include <cmath>
#include <vector>

#include "aisle/learning/walls/scanner_calibration.hpp"

namespace aisle {
namespace {

MeanAndDeviation statistics(const std::vector<double>& values) {
  MeanAndDeviation result;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) result.mean += value / count;
  if (values.size() < 2) return result;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / (count - 1));
  return result;
}

constexpr double kShortRelation_m = 3;  // the errors of longer ones hide where the frame sits

}  // namespace

Pose2 frame_of_relations(std::span<const Pose2> T_map_vehicle, std::span<const PoseRelation> relations) {
  std::vector<MotionPair> pairs;
  for (const PoseRelation& relation : relations) {
    if (relation.T_1_2.position().norm() > kShortRelation_m) continue;
    MotionPair pair;
    pair.laser = relation.T_1_2;
    pair.information = 1e4 * Mat3::Identity();
    pair.vehicle = between(T_map_vehicle[relation.scan_1], T_map_vehicle[relation.scan_2]);
    pairs.push_back(pair);
  }
  const auto found = find_mounting(pairs);
  if (!found) return {};
  const Pose2 frame = significant(*found, Pose2{});
  return {frame.x, frame.y, 0};
}

RelationError relation_error(std::span<const Pose2> T_map_vehicle, std::span<const PoseRelation> relations) {
  std::vector<double> translations_m, rotations_rad;
  for (const PoseRelation& relation : relations) {
    const Pose2 estimated = between(T_map_vehicle[relation.scan_1], T_map_vehicle[relation.scan_2]);
    const Pose2 error = between(relation.T_1_2, estimated);
    translations_m.push_back(std::hypot(error.x, error.y));
    rotations_rad.push_back(std::abs(error.theta));
  }
  return {relations.size(), statistics(translations_m), statistics(rotations_rad)};
}

}  // namespace aisle
