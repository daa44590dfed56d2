#include "rooms/pattern_views.hpp"

#include <cmath>

#include "aisle/maps/view_pattern.hpp"

namespace aisle {
namespace {

/// How far an image was taken from the wanted place, as a share of the tolerance; above 1: too far.
double off_place(const Pose2& off) {
  constexpr double kNear_m = 0.06, kTurned_rad = 3 * kDegree;
  return std::hypot(off.position().norm() / kNear_m, off.theta / kTurned_rad);
}

}  // namespace

std::vector<StopView> pattern_views(std::span<const RoomCycle> cycles, std::span<const Pose2> T_route_vehicle,
                                    const Pose2& T_route_place) {
  std::size_t places = 0;
  std::vector<StopView> views;
  for (const ViewLane& lane : view_pattern()) {
    for (const double along_m : lane.along_m) {
      ++places;
      const Pose2 T_route_wanted = T_route_place * lane.at(along_m);
      double least = 1;
      const RoomCycle* nearest = nullptr;
      double left_m = 0;
      for (std::size_t i = 0; i < cycles.size(); ++i) {
        const double off = off_place(between(T_route_wanted, T_route_vehicle[i]));
        if (!cycles[i].view || off >= least) continue;
        least = off;
        nearest = &cycles[i];
        left_m = between(T_route_vehicle[i], T_route_place).x;
      }
      if (nearest != nullptr) views.push_back({left_m, *nearest->view});
    }
  }
  return 3 * views.size() >= places ? views : std::vector<StopView>();
}

}  // namespace aisle
