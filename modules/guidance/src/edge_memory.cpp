#include "aisle/guidance/edge_memory.hpp"

#include <algorithm>

namespace aisle {

void EdgeMemory::take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle) {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::erase_if(edges_, [&](const Edge& edge) {
    const Vec2 p_vehicle = T_vehicle_odom * edge.p_odom;
    return p_vehicle.norm() > reach_m_ || view.sees_route(sight, p_vehicle);
  });
  for (const Vec2& p : sight.p_vehicle_edges) take({T_odom_vehicle * p, p.norm(), true});
  for (const Vec2& p : sight.p_vehicle_cut_off) take({T_odom_vehicle * p, p.norm(), false});
}

/// What was seen from far lies beside where it is; what is seen from nearer shows that.
void EdgeMemory::take(const Edge& seen) {
  constexpr double kSame_m = 0.04;  // nearer edges are one
  constexpr double kBeside_m = 0.25, kNearer = 0.7;
  bool is_known = false;
  std::erase_if(edges_, [&](const Edge& edge) {
    const double apart_m = (edge.p_odom - seen.p_odom).norm();
    const bool is_superseded =
        seen.is_foot && apart_m < kBeside_m && seen.seen_from_m < kNearer * edge.seen_from_m;
    is_known = is_known || (apart_m < kSame_m && !is_superseded && edge.is_foot == seen.is_foot);
    return is_superseded;
  });
  if (!is_known) edges_.push_back(seen);
}

void EdgeMemory::clear(const Pose2& T_odom_middle, const Vec2& size) {
  const Pose2 T_middle_odom = T_odom_middle.inverse();
  std::erase_if(edges_, [&](const Edge& edge) {
    const Vec2 p_middle = T_middle_odom * edge.p_odom;
    return (p_middle.cwiseAbs() - size / 2).maxCoeff() < 0;
  });
}

std::vector<Vec2> EdgeMemory::around(const Pose2& T_odom_vehicle) const {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::vector<Vec2> p_vehicle;
  p_vehicle.reserve(edges_.size());
  for (const Edge& edge : edges_) p_vehicle.push_back(T_vehicle_odom * edge.p_odom);
  return p_vehicle;
}

std::vector<SeenEdge> EdgeMemory::seen_around(const Pose2& T_odom_vehicle) const {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::vector<SeenEdge> seen;
  seen.reserve(edges_.size());
  for (const Edge& edge : edges_)
    if (edge.is_foot) seen.push_back({T_vehicle_odom * edge.p_odom, edge.seen_from_m});
  return seen;
}

}  // namespace aisle
