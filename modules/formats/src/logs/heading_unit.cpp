#include "logs/heading_unit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kStep_m = 0.1;
constexpr double kAgreement_rad = 20 * kDegree;
constexpr std::size_t kStepsMin = 10;

/// How many steps of the path lie along the heading, read as radians and as degrees.
struct HeadingVotes {
  std::size_t steps = 0, radians = 0, degrees = 0;
};

bool lies_along(double direction_rad, double heading_rad) {
  const double off_rad = std::abs(wrap_angle(direction_rad - heading_rad));
  return std::min(off_rad, kPi - off_rad) < kAgreement_rad;
}

HeadingVotes count_votes(const std::vector<OdometrySample>& odometry) {
  HeadingVotes votes;
  const Pose2* from = &odometry.front().T_odom_vehicle;
  for (const OdometrySample& sample : odometry) {
    const Pose2& to = sample.T_odom_vehicle;
    const Vec2 motion = to.position() - from->position();
    if (motion.norm() < kStep_m) continue;
    const double middle = (from->theta + to.theta) / 2;
    votes.radians += lies_along(heading_of(motion), middle);
    votes.degrees += lies_along(heading_of(motion), middle * kDegree);
    ++votes.steps;
    from = &to;
  }
  return votes;
}

std::size_t turns_too_fast(const std::vector<OdometrySample>& odometry) {
  constexpr double kTurn_rad = 1, kRate_radps = 6;
  std::size_t count = 0;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const double turn_rad = std::abs(odometry[i].T_odom_vehicle.theta - odometry[i - 1].T_odom_vehicle.theta);
    // A whole turn is the same heading, written otherwise.
    const bool is_whole_turn = std::abs(turn_rad - 2 * kPi) < 1;
    const double time_s = std::max(odometry[i].time_s - odometry[i - 1].time_s, 1e-3);
    count += turn_rad > kTurn_rad && !is_whole_turn && turn_rad / time_s > kRate_radps;
  }
  return count;
}

}  // namespace

void check_heading_unit(LaserRecording& recording, const std::string& name, Problems& problems) {
  const std::vector<OdometrySample>& odometry = recording.log.odometry;
  const bool leaves_circle = std::any_of(odometry.begin(), odometry.end(), [](const OdometrySample& sample) {
    return std::abs(sample.T_odom_vehicle.theta) > 2 * kPi;
  });
  if (!leaves_circle) return;
  const HeadingVotes votes = count_votes(odometry);
  if (votes.steps >= kStepsMin && 10 * votes.degrees > 8 * votes.steps && 2 * votes.radians < votes.steps) {
    problems.push_back({{name}, "the headings are degrees: the path follows them so; write them as radians"});
  } else if (10 * turns_too_fast(odometry) > odometry.size()) {
    recording.warnings.push_back(
        {{name}, "the headings turn faster than a vehicle can: are they degrees? They are read as radians"});
  }
}

}  // namespace aisle
