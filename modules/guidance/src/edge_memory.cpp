#include "aisle/guidance/edge_memory.hpp"

#include <algorithm>

namespace aisle {
namespace {

constexpr double kSame_m = 0.04;  // nearer edges are one

}  // namespace

void EdgeMemory::take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle) {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::erase_if(p_odom_, [&](const Vec2& p) {
    const Vec2 p_vehicle = T_vehicle_odom * p;
    return p_vehicle.norm() > reach_m_ || view.sees_route(sight, p_vehicle);
  });
  const std::size_t old = p_odom_.size();
  for (const Vec2& p_vehicle : sight.p_vehicle_edges) {
    const Vec2 p = T_odom_vehicle * p_vehicle;
    const auto end = p_odom_.begin() + static_cast<std::ptrdiff_t>(old);
    const bool is_known =
        std::any_of(p_odom_.begin(), end, [&](const Vec2& known) { return (known - p).norm() < kSame_m; });
    if (!is_known) p_odom_.push_back(p);
  }
}

void EdgeMemory::clear(const Pose2& T_odom_middle, const Vec2& size) {
  const Pose2 T_middle_odom = T_odom_middle.inverse();
  std::erase_if(p_odom_, [&](const Vec2& p) {
    const Vec2 p_middle = T_middle_odom * p;
    return (p_middle.cwiseAbs() - size / 2).maxCoeff() < 0;
  });
}

std::vector<Vec2> EdgeMemory::around(const Pose2& T_odom_vehicle) const {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::vector<Vec2> p_vehicle;
  p_vehicle.reserve(p_odom_.size());
  for (const Vec2& p : p_odom_) p_vehicle.push_back(T_vehicle_odom * p);
  return p_vehicle;
}

}  // namespace aisle
