#include "driven_legs.hpp"

#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// More turn than this within one step is a turn on the spot, ...
constexpr double kOnTheSpot_rad = 20 * kDegree;
/// ... of what was turned about a point so near.
constexpr double kSpot_m = 0.1;

double turned_on_the_spot_rad(const Pose2& from, const Pose2& to) {
  const double turn_rad = wrap_angle(to.theta - from.theta);
  return (to.position() - from.position()).norm() < kSpot_m * std::abs(turn_rad) ? turn_rad : 0;
}

Gear gear_between(const Pose2& from, const Pose2& to) {
  return gear_of((to.position() - from.position()).dot(unit(from.theta) + unit(to.theta)));
}

}  // namespace

std::vector<DrivenLeg> driven_legs(std::span<const Pose2> driven, double step_m) {
  std::vector<DrivenLeg> legs;
  Pose2 kept = driven.front();  // where the last step ended
  Vec2 p_map_farthest = kept.position();
  Pose2 before = kept;
  double spot_turn_rad = 0;  // since the last step ended
  for (const Pose2& pose : driven) {
    spot_turn_rad += turned_on_the_spot_rad(std::exchange(before, pose), pose);
    const auto ahead_m = [&](const Vec2& p_map) {
      return (legs.empty() ? 0 : sign(legs.back().gear)) * unit(kept.theta).dot(p_map - kept.position());
    };
    if (ahead_m(pose.position()) > ahead_m(p_map_farthest)) p_map_farthest = pose.position();
    if ((pose.position() - kept.position()).norm() < step_m) continue;

    const bool turned = std::abs(std::exchange(spot_turn_rad, 0)) > kOnTheSpot_rad;
    const double turn_rad = wrap_angle(pose.theta - kept.theta);
    const Gear gear = gear_between(turned ? Pose2{kept.x, kept.y, pose.theta} : kept, pose);
    if (legs.empty()) {
      legs.push_back({gear, {kept}, 0});
    } else if (turned || gear != legs.back().gear) {
      legs.back().samples.push_back({p_map_farthest.x(), p_map_farthest.y(), kept.theta});
      const double heading_rad = turned ? pose.theta : kept.theta;
      legs.push_back({gear, {{p_map_farthest.x(), p_map_farthest.y(), heading_rad}}, turned ? turn_rad : 0});
    }
    legs.back().samples.push_back(pose);
    kept = pose;
    p_map_farthest = kept.position();
  }
  const Pose2& last = driven.back();
  if (legs.empty()) {
    legs.push_back({gear_between(driven.front(), last), {driven.front(), last}, 0});
  } else if ((last.position() - kept.position()).norm() > 0) {
    legs.back().samples.push_back(last);
  }
  return legs;
}

}  // namespace aisle
