#include "aisle/simulation/obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/simulation/cross_section.hpp"

namespace aisle {
namespace {

constexpr double kCheckedEvery_m = 0.005;
constexpr double kGatheredAround_m = 2;
constexpr int kHalvings = 8;

}  // namespace

double distance_to(const Footprint& footprint, const Vec2& p_vehicle) {
  return std::max(0.0, off_footprint_m(footprint, p_vehicle));
}

/// Cuts the segment by each side of the rectangle in turn (Liang and Barsky); something must remain.
bool intersects(const Footprint& footprint, const Segment2& in_vehicle) {
  const double half_m = footprint.width_m / 2;
  const Vec2 from = in_vehicle.start, along = in_vehicle.end - in_vehicle.start;
  const std::array<std::pair<double, double>, 4> sides = {{{-along.x(), from.x() + footprint.rear_m},
                                                           {along.x(), footprint.front_m - from.x()},
                                                           {-along.y(), from.y() + half_m},
                                                           {along.y(), half_m - from.y()}}};
  double first = 0, last = 1;
  for (const auto& [outwards, room] : sides) {
    if (outwards == 0 && room < 0) return false;
    if (outwards < 0) first = std::max(first, room / outwards);
    if (outwards > 0) last = std::min(last, room / outwards);
  }
  return first <= last;
}

Obstacles::Obstacles(const World& world, const Footprint& footprint)
    : footprint_(footprint),
      reach_m_(std::hypot(std::max(footprint.front_m, footprint.rear_m), footprint.width_m / 2)),
      fixed_(obstacles_below(world, footprint.height_m)) {}

void Obstacles::gather_near(const Vec2& p_world) {
  if (gathered_at_ && (*gathered_at_ - p_world).norm() < kGatheredAround_m) return;
  gathered_at_ = p_world;
  near_.clear();
  for (const Segment2& segment : fixed_) {
    if (segment.distance(p_world) <= kGatheredAround_m + reach_m_) near_.push_back(segment);
  }
}

bool Obstacles::touch(const Pose2& T_world_vehicle) {
  gather_near(T_world_vehicle.position());
  const Pose2 T_vehicle_world = T_world_vehicle.inverse();
  const auto is_touched = [&](const Segment2& segment) {
    return segment.distance(T_world_vehicle.position()) <= reach_m_ &&
           intersects(footprint_, T_vehicle_world * segment);
  };
  return std::any_of(near_.begin(), near_.end(), is_touched) ||
         std::any_of(movers_.begin(), movers_.end(), is_touched);
}

double Obstacles::free_share(const Pose2& T_world_vehicle, const Arc& path) {
  const auto touch_after = [&](double share) {
    return touch(T_world_vehicle * end_pose({share * path.length_m, share * path.turn_rad}));
  };
  const double swept_m = std::abs(path.length_m) + std::abs(path.turn_rad) * reach_m_;
  const int checks = 1 + static_cast<int>(swept_m / kCheckedEvery_m);
  for (int i = 1; i <= checks; ++i) {
    double free = static_cast<double>(i - 1) / checks, touching = static_cast<double>(i) / checks;
    if (!touch_after(touching)) continue;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = (free + touching) / 2;
      (touch_after(middle) ? touching : free) = middle;
    }
    return free;
  }
  return 1;
}

}  // namespace aisle
