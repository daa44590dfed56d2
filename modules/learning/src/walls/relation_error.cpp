#include "aisle/learning/walls/relation_error.hpp"

#include <cmath>
#include <vector>

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

}  // namespace

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
