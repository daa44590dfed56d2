#include "landmark_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kWrong_m = 0.5;
constexpr double kBack_m = 0.5;   // along the path, in which its nearest point is looked for
constexpr double kAhead_m = 1.0;

}  // namespace

MapTruth::MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught)
    : T_map_taught_(std::move(T_map_taught)), T_world_taught_(std::move(T_world_taught)) {}

Pose2 MapTruth::on_map(const Pose2& T_world_vehicle, const Pose2& T_map_thought) const {
  const std::size_t i = nearest(T_map_thought);
  return T_map_taught_[i] * between(T_world_taught_[i], T_world_vehicle);
}

Pose2 MapTruth::in_world(const Pose2& T_map_place) const {
  const std::size_t i = nearest(T_map_place);
  return T_world_taught_[i] * between(T_map_taught_[i], T_map_place);
}

std::size_t MapTruth::nearest(const Pose2& T_map_place) const {
  const auto distance = [&](const Pose2& T) { return (T.position() - T_map_place.position()).squaredNorm(); };
  const auto found =
      std::min_element(T_map_taught_.begin(), T_map_taught_.end(),
                       [&](const Pose2& a, const Pose2& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(found - T_map_taught_.begin());
}

void ErrorFigure::add(double error) {
  sum_of_squares_ += error * error;
  worst_ = std::max(worst_, std::abs(error));
  ++count_;
}

double ErrorFigure::rms() const {
  return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
}

void MissionErrors::add(const LandmarkFix& fix, const Pose2& T_world_vehicle) {
  const Pose2 T_map_true = truth_.on_map(T_world_vehicle, fix.T_map_vehicle.mean);
  const PathPoint nearest =
      path_.nearest(T_map_true.position(), along_path_m_ - kBack_m, along_path_m_ + kAhead_m);
  along_path_m_ = nearest.along_m;
  if (!fix.is_sure) return;
  const Pose2 error = between(T_map_true, fix.T_map_vehicle.mean);
  along_m.add(error.x);
  across_m.add(error.y);
  heading_rad.add(error.theta);
  tracking_m.add((T_map_true.position() - nearest.T_map_path.position()).norm());
  wrong_confident = wrong_confident || error.position().norm() > kWrong_m;
}

}  // namespace aisle
