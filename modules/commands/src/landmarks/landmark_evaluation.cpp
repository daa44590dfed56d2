#include "landmarks/landmark_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kWrong_m = 0.5;
constexpr double kWrongMax_s = 3;
constexpr double kNear_m = 3;    // of way, from one cycle's taught pose to the next one's
constexpr double kBack_m = 0.5;  // along the path, in which its nearest point is looked for
constexpr double kAhead_m = 1.0;

}  // namespace

MapTruth::MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught)
    : T_map_taught_(std::move(T_map_taught)), T_world_taught_(std::move(T_world_taught)) {
  for (std::size_t i = 0; i < T_map_taught_.size(); ++i) {
    const double step_m = i == 0 ? 0 : between(T_map_taught_[i - 1], T_map_taught_[i]).position().norm();
    way_m_.push_back(i == 0 ? 0 : way_m_.back() + step_m);
  }
}

Pose2 MapTruth::on_map(const Pose2& T_world_vehicle, std::size_t taught) const {
  return T_map_taught_[taught] * between(T_world_taught_[taught], T_world_vehicle);
}

Pose2 MapTruth::in_world(const Pose2& T_map_place, std::size_t taught) const {
  return T_world_taught_[taught] * between(T_map_taught_[taught], T_map_place);
}

Pose2 MapTruth::in_world(const Pose2& T_map_place) const {
  return in_world(T_map_place, nearest(T_map_place));
}

std::size_t MapTruth::nearest(const Pose2& T_map_place) const {
  const auto distance = [&](const Pose2& T) { return (T.position() - T_map_place.position()).squaredNorm(); };
  const auto found =
      std::min_element(T_map_taught_.begin(), T_map_taught_.end(),
                       [&](const Pose2& a, const Pose2& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(found - T_map_taught_.begin());
}

std::size_t MapTruth::nearest(const Pose2& T_map_place, std::size_t near) const {
  const auto distance = [&](std::size_t i) {
    return (T_map_taught_[i].position() - T_map_place.position()).squaredNorm();
  };
  std::size_t best = near;
  for (std::size_t i = near; i-- > 0 && way_m_[near] - way_m_[i] < kNear_m;) {
    if (distance(i) < distance(best)) best = i;
  }
  for (std::size_t i = near + 1; i < way_m_.size() && way_m_[i] - way_m_[near] < kNear_m; ++i) {
    if (distance(i) < distance(best)) best = i;
  }
  return best;
}

void ErrorFigure::add(double error) {
  sum_of_squares_ += error * error;
  worst_ = std::max(worst_, std::abs(error));
  ++count_;
}

double ErrorFigure::rms() const {
  return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
}

/// A vehicle that was lost, and perhaps lifted, may have found itself anywhere on its way.
void MissionJudge::find_again(const LandmarkFix& fix) {
  taught_ = truth_.nearest(fix.T_map_vehicle.mean);
  along_path_m_ = path_.nearest(fix.T_map_vehicle.mean.position(), 0, path_.length_m()).along_m;
}

void MissionJudge::add(double stamp_s, const LandmarkFix& fix, const Pose2& T_world_vehicle) {
  if (is_lost_ && fix.is_sure) find_again(fix);
  is_lost_ = fix.is_lost;
  taught_ = truth_.nearest(fix.T_map_vehicle.mean, taught_);
  const Pose2 T_map_true = truth_.on_map(T_world_vehicle, taught_);
  const PathPoint nearest =
      path_.nearest(T_map_true.position(), along_path_m_ - kBack_m, along_path_m_ + kAhead_m);
  along_path_m_ = nearest.along_m;
  const Pose2 error = between(T_map_true, fix.T_map_vehicle.mean);
  errors_.knew_place_at_end = !fix.is_lost && error.position().norm() <= kWrong_m;
  if (!fix.is_sure || error.position().norm() <= kWrong_m) {
    wrong_since_s_.reset();
  } else {
    if (!wrong_since_s_) wrong_since_s_ = stamp_s;
    errors_.wrong_confident = errors_.wrong_confident || stamp_s - *wrong_since_s_ > kWrongMax_s;
  }
  if (!fix.is_sure) return;
  errors_.along_m.add(error.x);
  errors_.across_m.add(error.y);
  errors_.heading_rad.add(error.theta);
  errors_.tracking_m.add((T_map_true.position() - nearest.T_map_path.position()).norm());
}

}  // namespace aisle
