#pragma once

#include <cstdint>
#include <vector>

#include "aisle/maps/room_route.hpp"

namespace aisle {

/// Spatial index of a route's taught edges. It contains only those seen along a segment of the path: a route
/// may return to a place after the odometry has drifted, and would otherwise show the same walls twice.
class TaughtEdges {
 public:
  struct Edge {
    double along_m = 0;
    Vec2 p_map = Vec2::Zero();
    Vec2 normal = Vec2::Zero();  ///< of the line that its neighbours form; zero if they form none
    int side = 0;                ///< number of its side: edges on one line without a gap form a side
  };

  /// @param reach_m  edges farther from a point than this are not found
  TaughtEdges(const std::vector<RouteEdge>& edges, double reach_m);

  /// Prepares for queries within 10 m of `p_map`; cheap while that does not change much.
  /// @param window_m  only edges seen within this distance before or beyond `along_m` count
  void move_to(double along_m, double window_m, const Vec2& p_map);

  /// The nearest edge within reach; nullptr if there is none, or if the point is outside the prepared area.
  const Edge* nearest(const Vec2& p_map) const;

  /// Approximate length of each side, by its number.
  const std::vector<double>& side_lengths_m() const { return side_lengths_m_; }

  /// The segment's edges within a distance.
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
  std::size_t first_ = 0, end_ = 0;  ///< range of the segment's edges
};

}  // namespace aisle
