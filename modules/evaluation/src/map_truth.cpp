#include "aisle/evaluation/map_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kTaughtAhead_m = 1.0;  // path length searched for the next taught pose along a path
constexpr double kNearer_m = 0.01;      // a taught pose must be nearer by this much to replace an earlier one

}  // namespace

MapTruth::MapTruth(std::vector<Pose2> T_map_taught, std::vector<Pose2> T_world_taught)
    : T_map_taught_(std::move(T_map_taught)), T_world_taught_(std::move(T_world_taught)) {
  for (std::size_t i = 0; i < T_map_taught_.size(); ++i) {
    const double step_m = i == 0 ? 0 : between(T_map_taught_[i - 1], T_map_taught_[i]).position().norm();
    travelled_m_.push_back(i == 0 ? 0 : travelled_m_.back() + step_m);
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

std::vector<std::size_t> MapTruth::along(const Path& path, bool in_reverse) const {
  const std::size_t count = T_map_taught_.size();
  const auto in_order = [&](std::size_t i) { return in_reverse ? count - 1 - i : i; };
  const auto steps = static_cast<std::size_t>(path.length_m() / kAlongStep_m);
  std::vector<std::size_t> taught;
  std::size_t last = 0;
  for (std::size_t step = 0; step <= steps; ++step) {
    const Vec2 p_map = path.at(static_cast<double>(step) * kAlongStep_m).T_map_path.position();
    const auto distance = [&](std::size_t i) {
      return (T_map_taught_[in_order(i)].position() - p_map).norm();
    };
    const double from_m = travelled_m_[in_order(last)];
    for (std::size_t i = last + 1; i < count && std::abs(travelled_m_[in_order(i)] - from_m) < kTaughtAhead_m;
         ++i)
      if (distance(i) < distance(last) - kNearer_m) last = i;
    taught.push_back(in_order(last));
  }
  return taught;
}

}  // namespace aisle
