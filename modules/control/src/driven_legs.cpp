#include "driven_legs.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// More turn than this within one step is a turn on the spot.
constexpr double kOnTheSpot_rad = 20 * kDegree;

double direction_of(const Pose2& from, const Pose2& to) {
  return (to.position() - from.position()).dot(unit(from.theta) + unit(to.theta)) < 0 ? -1 : 1;
}

}  // namespace

std::vector<DrivenLeg> driven_legs(std::span<const Pose2> driven, double step_m) {
  std::vector<DrivenLeg> legs;
  Pose2 kept = driven.front(), before = driven.front();
  for (const Pose2& pose : driven) {
    const double turn_rad = wrap_angle(pose.theta - kept.theta);
    const double way_m = (pose.position() - kept.position()).norm();
    if (way_m < step_m) {
      before = pose;
      continue;
    }
    const bool turned = std::abs(turn_rad) > kOnTheSpot_rad;
    const Pose2 T_map_from = turned ? before : kept;
    const double direction = direction_of(T_map_from, pose);
    if (legs.empty() || turned || direction != legs.back().direction) {
      const double turn_before_rad =
          turned && !legs.empty() ? wrap_angle(T_map_from.theta - legs.back().samples.back().theta) : 0;
      legs.push_back({direction, {T_map_from}, turn_before_rad});
    }
    legs.back().samples.push_back(pose);
    kept = before = pose;
  }
  const Pose2& last = driven.back();
  if (legs.empty()) {
    legs.push_back({direction_of(driven.front(), last), {driven.front(), last}, 0});
  } else if ((last.position() - kept.position()).norm() > 0) {
    legs.back().samples.push_back(last);
  }
  return legs;
}

}  // namespace aisle
