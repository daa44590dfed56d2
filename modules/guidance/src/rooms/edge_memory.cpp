#include "aisle/guidance/rooms/edge_memory.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kSeenOff_m = 0.25;  // error of a point that was seen from far
constexpr double kLookKept_s = 5;

}  // namespace

/// Covers also what the view did not reach before: an obstacle is larger than a point.
bool EdgeMemory::is_beside_any(const std::vector<Edge>& edges, const Vec2& p_odom) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return (edge.p_odom - p_odom).norm() < kSeenOff_m; });
}

void EdgeMemory::take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle,
                      double stamp_s) {
  forget_gone(view, sight, T_odom_vehicle);
  seen_.clear();
  come_.clear();
  const auto see = [&](const std::vector<Vec2>& p_vehicle_edges, bool is_floor_edge) {
    for (const Vec2& p_vehicle : p_vehicle_edges) {
      const Vec2 p_odom = T_odom_vehicle * p_vehicle;
      const bool has_come = was_free(view, p_odom, stamp_s) && !has_stood_at(p_odom, stamp_s);
      seen_.push_back({p_odom, p_vehicle.norm(), is_floor_edge, stamp_s, stamp_s, has_come});
      if (has_come) come_.push_back(seen_.back());
    }
  };
  see(sight.p_vehicle_edges, true);
  see(sight.p_vehicle_cut_off, false);
  for (Edge& edge : seen_) {
    edge.has_come = !has_stood_at(edge.p_odom, stamp_s) && is_beside_any(come_, edge.p_odom);
    take(edge);
  }
  forget_moved_on(stamp_s);
  keep_look(sight, T_odom_vehicle, stamp_s);
}

void EdgeMemory::forget_gone(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle) {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  std::erase_if(edges_, [&](const Edge& edge) {
    const Vec2 p_vehicle = T_vehicle_odom * edge.p_odom;
    const bool is_gone = view.sees_route(sight, p_vehicle);
    if (is_gone && edge.has_come) gone_.push_back(edge);
    return is_gone || p_vehicle.norm() > reach_m_;
  });
}

/// Out of view nothing shows that a person has left; a person who was seen walking is assumed to walk on.
void EdgeMemory::forget_moved_on(double stamp_s) {
  constexpr double kSurelyGone_s = 8;
  std::erase_if(edges_, [&](const Edge& edge) {
    return edge.has_come && stamp_s - edge.last_s > kSurelyGone_s && has_moved_on(edge);
  });
  constexpr double kKept_s = 2 * kSurelyGone_s;
  std::erase_if(gone_, [&](const Edge& edge) { return stamp_s - edge.last_s > kKept_s; });
}

bool EdgeMemory::was_free(const RouteView& view, const Vec2& p_odom, double stamp_s) const {
  constexpr double kBefore_s = 0.5;
  return std::any_of(looks_.begin(), looks_.end(), [&](const Look& look) {
    const double ago_s = stamp_s - look.stamp_s;
    return ago_s > kBefore_s && ago_s <= kLookKept_s &&
           view.sees_route(look.sight, look.T_odom_vehicle.inverse() * p_odom);
  });
}

/// Whether an obstacle stood there before, and is only seen better now.
bool EdgeMemory::has_stood_at(const Vec2& p_odom, double stamp_s) const {
  constexpr double kStood_s = 1;
  return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
    return !edge.has_come && stamp_s - edge.first_s > kStood_s && (edge.p_odom - p_odom).norm() < kSeenOff_m;
  });
}

/// Whether another edge appeared beside it at about the same time, and is gone by now.
bool EdgeMemory::has_moved_on(const Edge& edge) const {
  constexpr double kStep_m = 0.15, kStride_m = 1, kStride_s = 1;
  return std::any_of(gone_.begin(), gone_.end(), [&](const Edge& gone) {
    const double apart_m = (gone.p_odom - edge.p_odom).norm();
    return apart_m > kStep_m && apart_m < kStride_m && std::abs(gone.first_s - edge.first_s) < kStride_s;
  });
}

/// A point seen from far is inaccurate; one seen from nearer replaces it.
void EdgeMemory::take(const Edge& seen) {
  constexpr double kSame_m = 0.04;  // edges closer together than this are one
  constexpr double kNearer = 0.7;
  const auto apart_m = [&](const Edge& edge) { return (edge.p_odom - seen.p_odom).norm(); };
  std::erase_if(edges_, [&](const Edge& edge) {
    return seen.is_floor_edge && apart_m(edge) < kSeenOff_m && seen.seen_from_m < kNearer * edge.seen_from_m;
  });
  bool is_known = false;
  for (Edge& edge : edges_) {
    if (apart_m(edge) >= kSame_m || edge.is_floor_edge != seen.is_floor_edge) continue;
    edge.last_s = seen.last_s;
    edge.has_come = edge.has_come && seen.has_come;
    is_known = true;
  }
  if (!is_known) edges_.push_back(seen);
}

/// Reuses the oldest one's memory.
void EdgeMemory::keep_look(const RouteSight& sight, const Pose2& T_odom_vehicle, double stamp_s) {
  constexpr double kApart_s = 0.5;
  if (!looks_.empty() && stamp_s - looks_.back().stamp_s < kApart_s) return;
  if (looks_.empty() || stamp_s - looks_.front().stamp_s <= kLookKept_s)
    looks_.emplace_back();
  else
    std::rotate(looks_.begin(), looks_.begin() + 1, looks_.end());
  Look& look = looks_.back();
  look.stamp_s = stamp_s;
  look.T_odom_vehicle = T_odom_vehicle;
  look.sight = sight;
}

void EdgeMemory::correct(const OdometryHistory& before, const OdometryHistory& now) {
  const auto now_before = [&](double stamp_s) {
    return now.T_odom_at(stamp_s) * before.T_odom_at(stamp_s).inverse();
  };
  for (Edge& edge : edges_) edge.p_odom = now_before(edge.first_s) * edge.p_odom;
  for (Edge& edge : gone_) edge.p_odom = now_before(edge.first_s) * edge.p_odom;
  for (Look& look : looks_) look.T_odom_vehicle = now_before(look.stamp_s) * look.T_odom_vehicle;
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
    if (edge.is_floor_edge) seen.push_back({T_vehicle_odom * edge.p_odom, edge.seen_from_m});
  return seen;
}

}  // namespace aisle
