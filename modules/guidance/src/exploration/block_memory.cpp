#include "aisle/guidance/exploration/block_memory.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kSameSpot_m = 0.2;
constexpr double kBarredAhead_m = 0.08;  // from where it was stopped to the barred pose
constexpr double kBarredAlong_m = 0.08;  // poses this near to a barred pose are barred, too
constexpr double kBarredAcross_m = 0.04;
constexpr double kBarredTurn_rad = 10 * kDegree;  // the same of a vehicle that was turning on the spot
constexpr double kBarred_rad = 6 * kDegree;

/// The vehicle where it would have been next.
Pose2 just_beyond(LegDirection direction) {
  switch (direction) {
    case LegDirection::kForward:
      return {kBarredAhead_m, 0, 0};
    case LegDirection::kReverse:
      return {-kBarredAhead_m, 0, 0};
    case LegDirection::kLeft:
      return {0, 0, kBarredTurn_rad};
    case LegDirection::kRight:
      return {0, 0, -kBarredTurn_rad};
  }
  return {};
}

}  // namespace

void BlockMemory::note(const Pose2& T_map_vehicle, std::optional<LegDirection> direction) {
  times_ = was_at(T_map_vehicle) ? times_ + 1 : 1;
  p_map_ = T_map_vehicle.position();
  blocked_direction_ = direction;
  T_map_barred_.push_back(direction ? T_map_vehicle * just_beyond(*direction) : T_map_vehicle);
}

bool BlockMemory::was_at(const Pose2& T_map) const {
  return (T_map.position() - p_map_).norm() < kSameSpot_m;
}

bool BlockMemory::is_barred(const Pose2& T_map) const {
  return std::any_of(T_map_barred_.begin(), T_map_barred_.end(), [&](const Pose2& T_map_barred) {
    const Pose2 off = between(T_map_barred, T_map);
    return std::abs(off.x) < kBarredAlong_m && std::abs(off.y) < kBarredAcross_m &&
           std::abs(off.theta) < kBarred_rad;
  });
}

}  // namespace aisle
