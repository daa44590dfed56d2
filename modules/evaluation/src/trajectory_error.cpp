#include "aisle/evaluation/trajectory_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kTruthGapMax_s = 0.25;
constexpr std::size_t kComparedMin = 3;

std::optional<Pose2> truth_at(const Trajectory& truth, double stamp_s) {
  const auto& stamps_s = truth.stamps_s;
  const auto after = std::lower_bound(stamps_s.begin(), stamps_s.end(), stamp_s);
  if (after == stamps_s.end()) return std::nullopt;
  const auto next = static_cast<std::size_t>(after - stamps_s.begin());
  if (*after == stamp_s) return truth.T_map_vehicle[next];
  if (next == 0 || *after - stamps_s[next - 1] > kTruthGapMax_s) return std::nullopt;
  const double share = (stamp_s - stamps_s[next - 1]) / (*after - stamps_s[next - 1]);
  const Pose2 &from = truth.T_map_vehicle[next - 1], &to = truth.T_map_vehicle[next];
  return Pose2{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
               from.theta + share * wrap_angle(to.theta - from.theta)};
}

/// The least squares rotation and translation from `points` onto `others`: Umeyama 1991, in the plane,
/// without scale.
Pose2 alignment(const std::vector<Pose2>& points, const std::vector<Pose2>& others) {
  Vec2 p_mean = Vec2::Zero(), q_mean = Vec2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    p_mean += points[i].position() / static_cast<double>(points.size());
    q_mean += others[i].position() / static_cast<double>(points.size());
  }
  double dot = 0, cross = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i].position() - p_mean, q = others[i].position() - q_mean;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
  }
  const Pose2 turn{0, 0, std::atan2(cross, dot)};
  const Vec2 p_turned = (turn * Pose2{p_mean.x(), p_mean.y(), 0}).position();
  return {q_mean.x() - p_turned.x(), q_mean.y() - p_turned.y(), turn.theta};
}

double mean_heading_difference(const std::vector<Pose2>& from, const std::vector<Pose2>& to) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) sum += unit(to[i].theta - from[i].theta);
  return std::atan2(sum.y(), sum.x());
}

class SpreadOf {
 public:
  void add(double error) {
    const double magnitude = std::abs(error);
    ++count_;
    sum_ += magnitude;
    squares_ += magnitude * magnitude;
    max_ = std::max(max_, magnitude);
  }
  ErrorSpread spread() const {
    const double count = std::max(1.0, static_cast<double>(count_));
    return {sum_ / count, std::sqrt(squares_ / count), max_};
  }

 private:
  std::size_t count_ = 0;
  double sum_ = 0, squares_ = 0, max_ = 0;
};

void add_absolute_errors(TrajectoryError& error) {
  SpreadOf position_m, heading_rad;
  for (std::size_t i = 0; i < error.compared; ++i) {
    const Pose2 &pose = error.T_truth_vehicle[i], &truth = error.T_truth_true[i];
    position_m.add((pose.position() - truth.position()).norm());
    heading_rad.add(wrap_angle(pose.theta - truth.theta));
  }
  error.position_m = position_m.spread();
  error.heading_rad = heading_rad.spread();
}

/// Of every pose and the first one that is `step_m` of true path later.
void add_relative_errors(TrajectoryError& error) {
  std::vector<double> path_m(error.compared, 0.0);
  for (std::size_t i = 1; i < error.compared; ++i)
    path_m[i] =
        path_m[i - 1] + (error.T_truth_true[i].position() - error.T_truth_true[i - 1].position()).norm();
  SpreadOf position_m, heading_rad;
  for (std::size_t i = 0; i < error.compared; ++i) {
    const auto end = std::lower_bound(path_m.begin(), path_m.end(), path_m[i] + error.step_m);
    if (end == path_m.end()) break;
    const auto j = static_cast<std::size_t>(end - path_m.begin());
    const Pose2 moved = error.T_truth_vehicle[i].inverse() * error.T_truth_vehicle[j];
    const Pose2 truly = error.T_truth_true[i].inverse() * error.T_truth_true[j];
    position_m.add((moved.position() - truly.position()).norm());
    heading_rad.add(wrap_angle(moved.theta - truly.theta));
  }
  error.relative_position_m = position_m.spread();
  error.relative_heading_rad = heading_rad.spread();
}

}  // namespace

Result<TrajectoryError> trajectory_error(const Trajectory& trajectory, const Trajectory& truth,
                                         double step_m) {
  if (!std::is_sorted(truth.stamps_s.begin(), truth.stamps_s.end()))
    return Problem{{"truth"}, "its stamps go back"};
  TrajectoryError error{.step_m = step_m};
  for (std::size_t i = 0; i < trajectory.stamps_s.size(); ++i) {
    const auto true_pose = truth_at(truth, trajectory.stamps_s[i]);
    if (!true_pose) continue;
    error.stamps_s.push_back(trajectory.stamps_s[i]);
    error.T_truth_vehicle.push_back(trajectory.T_map_vehicle[i]);
    error.T_truth_true.push_back(*true_pose);
  }
  error.compared = error.stamps_s.size();
  error.without_truth = trajectory.stamps_s.size() - error.compared;
  if (error.compared < kComparedMin)
    return Problem{{"truth"},
                   fmt::format("{} of {} poses have a true pose within {} s of their stamps; {} are needed",
                               error.compared, trajectory.stamps_s.size(), kTruthGapMax_s, kComparedMin)};
  error.T_truth_map = alignment(error.T_truth_vehicle, error.T_truth_true);
  for (Pose2& pose : error.T_truth_vehicle) pose = error.T_truth_map * pose;
  error.heading_offset_rad = mean_heading_difference(error.T_truth_vehicle, error.T_truth_true);
  for (Pose2& pose : error.T_truth_true) pose.theta = wrap_angle(pose.theta - error.heading_offset_rad);
  add_absolute_errors(error);
  add_relative_errors(error);
  return error;
}

}  // namespace aisle
