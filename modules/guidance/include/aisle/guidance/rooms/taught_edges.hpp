#pragma once

#include <cstdint>
#include <vector>

#include "aisle/maps/room_route.hpp"

namespace aisle {

/// The edges of a route as they were taught, found by place: those that belong to a path segment, so
/// that paths that come back to where they were, after the odometry has drifted, do not show two rooms in
/// one.
class TaughtEdges {
 public:
  struct Edge {
    double along_m = 0;
    Vec2 p_map = Vec2::Zero();
    Vec2 normal = Vec2::Zero();  ///< across the line that its neighbours lie on; zero: they lie on none
    int side = 0;                ///< its number: edges on one line, without a gap, are one side of something
  };

  /// @param reach_m  edges farther from a place than this are not found there
  TaughtEdges(const std::vector<RouteEdge>& edges, double reach_m);

  /// Prepares for questions about places within 10 m of `p_map`; cheap while that does not change much.
  /// @param window_m  edges that were seen so far before or beyond `along_m` count
  void move_to(double along_m, double window_m, const Vec2& p_map);

  /// The nearest edge within reach; nullptr: none, or too far from where it was prepared for.
  const Edge* nearest(const Vec2& p_map) const;

  /// About how long each side is, by its number.
  const std::vector<double>& side_lengths_m() const { return side_lengths_m_; }

  /// Those of the segment that lie within a distance.
  std::vector<Vec2> around(const Vec2& p_map, double within_m) const;

 private:
  void stamp(std::size_t edge);
  void number_sides();

  double reach_m_;
  std::vector<Edge> edges_;
  std::vector<double> side_lengths_m_;
  bool is_prepared_ = false;
  double along_m_ = 0;
  Vec2 p_map_low_ = Vec2::Zero();
  std::vector<std::int32_t> nearest_;  ///< for each cell, an edge's number or -1
  std::vector<float> off_m_;
  std::size_t first_ = 0, end_ = 0;  ///< of the segment
};

}  // namespace aisle
