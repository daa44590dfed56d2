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
constexpr double kBarred_rad = 6 * kDegree;

}  // namespace

void BlockMemory::note(const Pose2& T_map_vehicle, std::optional<Gear> gear) {
  times_ = was_at(T_map_vehicle) ? times_ + 1 : 1;
  p_map_ = T_map_vehicle.position();
  blocked_gear_ = gear;
  const double ahead_m = gear ? sign(*gear) * kBarredAhead_m : 0;
  T_map_barred_.push_back(T_map_vehicle * Pose2{ahead_m, 0, 0});
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
