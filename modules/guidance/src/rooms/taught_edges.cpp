#include "aisle/guidance/rooms/taught_edges.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kRasterCell_m = 0.05, kHalfWidth_m = 10;
constexpr int kRasterCells = 400;    // along a side
constexpr double kNearEnough_m = 1;  // the raster is kept until the vehicle has moved this far

/// Normal of the line that the points form; zero if they form none.
Vec2 normal_of(const std::vector<Vec2>& points) {
  constexpr std::size_t kLinePoints = 4;
  constexpr double kFlat = 0.1;
  if (points.size() < kLinePoints) return Vec2::Zero();
  Vec2 middle = Vec2::Zero();
  for (const Vec2& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  Mat2 spread = Mat2::Zero();
  for (const Vec2& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat2> axes(spread);
  const bool is_line = axes.eigenvalues()(0) < kFlat * axes.eigenvalues()(1);
  return is_line ? Vec2(axes.eigenvectors().col(0)) : Vec2::Zero();
}

constexpr double kEdgeNeighbours_m = 0.2, kEdgeIndexCell_m = 0.5;

CellIndex index_of(const std::vector<TaughtEdges::Edge>& edges) {
  CellIndex index(kEdgeIndexCell_m);
  for (std::size_t i = 0; i < edges.size(); ++i)
    index.add({edges[i].p_map, edges[i].p_map}, static_cast<int>(i));
  return index;
}

/// Whether neighbours lie on one line, or both on none.
bool is_one_side(const TaughtEdges::Edge& a, const TaughtEdges::Edge& b) {
  constexpr double kAlong = 0.95, kOffSide_m = 0.06;
  if (a.normal.isZero() || b.normal.isZero()) return a.normal.isZero() && b.normal.isZero();
  return std::abs(a.normal.dot(b.normal)) > kAlong && std::abs(a.normal.dot(b.p_map - a.p_map)) < kOffSide_m;
}

int raster_cell(double from_low_m) {
  return static_cast<int>(std::floor(from_low_m / kRasterCell_m));
}

}  // namespace

TaughtEdges::TaughtEdges(const std::vector<RouteEdge>& edges, double reach_m) : reach_m_(reach_m) {
  edges_.reserve(edges.size());
  for (const RouteEdge& edge : edges) edges_.push_back({.along_m = edge.along_m, .p_map = edge.p_map});
  std::stable_sort(edges_.begin(), edges_.end(),
                   [](const Edge& a, const Edge& b) { return a.along_m < b.along_m; });
  const CellIndex index = index_of(edges_);
  std::vector<int> near;
  std::vector<Vec2> points;
  for (Edge& edge : edges_) {
    index.query(edge.p_map, edge.p_map, kEdgeNeighbours_m, near);
    points.clear();
    for (const int i : near) {
      const Vec2& p = edges_[static_cast<std::size_t>(i)].p_map;
      if ((p - edge.p_map).norm() < kEdgeNeighbours_m) points.push_back(p);
    }
    edge.normal = normal_of(points);
  }
  number_sides();
}

/// Region growing from neighbour to neighbour.
void TaughtEdges::number_sides() {
  constexpr int kNone = -1;
  constexpr double kApart_m = 0.05;  // of edges on a line, as they are learned
  const CellIndex index = index_of(edges_);
  for (Edge& edge : edges_) edge.side = kNone;
  std::vector<std::size_t> waiting;
  std::vector<int> near;
  for (std::size_t first = 0; first < edges_.size(); ++first) {
    if (edges_[first].side != kNone) continue;
    const int side = static_cast<int>(side_lengths_m_.size());
    side_lengths_m_.push_back(kApart_m);
    edges_[first].side = side;
    waiting.assign(1, first);
    while (!waiting.empty()) {
      const Edge& edge = edges_[waiting.back()];
      waiting.pop_back();
      index.query(edge.p_map, edge.p_map, kEdgeNeighbours_m, near);
      for (const int i : near) {
        Edge& other = edges_[static_cast<std::size_t>(i)];
        if (other.side != kNone || (other.p_map - edge.p_map).norm() >= kEdgeNeighbours_m ||
            !is_one_side(edge, other))
          continue;
        other.side = side;
        side_lengths_m_.back() += kApart_m;
        waiting.push_back(static_cast<std::size_t>(i));
      }
    }
  }
}

void TaughtEdges::move_to(double along_m, double window_m, const Vec2& p_map) {
  const Vec2 p_map_low = p_map - Vec2(kHalfWidth_m, kHalfWidth_m);
  if (is_prepared_ && std::abs(along_m - along_m_) < kNearEnough_m &&
      (p_map_low - p_map_low_).norm() < kNearEnough_m)
    return;
  is_prepared_ = true;
  along_m_ = along_m;
  p_map_low_ = p_map_low;
  const auto before = [](const Edge& edge, double at_m) { return edge.along_m < at_m; };
  const auto first = std::lower_bound(edges_.begin(), edges_.end(), along_m - window_m, before);
  const auto end = std::lower_bound(first, edges_.end(), along_m + window_m, before);
  first_ = static_cast<std::size_t>(first - edges_.begin());
  end_ = static_cast<std::size_t>(end - edges_.begin());
  constexpr auto kAllCells = static_cast<std::size_t>(kRasterCells) * kRasterCells;
  nearest_.assign(kAllCells, -1);
  off_m_.assign(kAllCells, static_cast<float>(reach_m_));
  for (std::size_t i = first_; i < end_; ++i) stamp(i);
}

/// Enters an edge into the cells to which it is the nearest one.
void TaughtEdges::stamp(std::size_t edge) {
  const Vec2 at = edges_[edge].p_map - p_map_low_;
  if (at.minCoeff() < 0 || at.maxCoeff() >= 2 * kHalfWidth_m) return;
  const int reach = raster_cell(reach_m_) + 1, x = raster_cell(at.x()), y = raster_cell(at.y());
  for (int v = std::max(0, y - reach); v <= std::min(kRasterCells - 1, y + reach); ++v) {
    for (int u = std::max(0, x - reach); u <= std::min(kRasterCells - 1, x + reach); ++u) {
      const Vec2 middle((u + 0.5) * kRasterCell_m, (v + 0.5) * kRasterCell_m);
      const auto off_m = static_cast<float>((middle - at).norm());
      const std::size_t cell = static_cast<std::size_t>(v) * kRasterCells + static_cast<std::size_t>(u);
      if (off_m >= off_m_[cell]) continue;
      off_m_[cell] = off_m;
      nearest_[cell] = static_cast<std::int32_t>(edge);
    }
  }
}

const TaughtEdges::Edge* TaughtEdges::nearest(const Vec2& p_map) const {
  const Vec2 at = p_map - p_map_low_;
  if (!is_prepared_ || at.minCoeff() < 0 || at.maxCoeff() >= 2 * kHalfWidth_m) return nullptr;
  const int x = std::min(raster_cell(at.x()), kRasterCells - 1),
            y = std::min(raster_cell(at.y()), kRasterCells - 1);
  const std::int32_t edge =
      nearest_[static_cast<std::size_t>(y) * kRasterCells + static_cast<std::size_t>(x)];
  return edge < 0 ? nullptr : &edges_[static_cast<std::size_t>(edge)];
}

std::vector<Vec2> TaughtEdges::around(const Vec2& p_map, double within_m) const {
  std::vector<Vec2> points;
  for (std::size_t i = first_; i < end_; ++i)
    if ((edges_[i].p_map - p_map).norm() < within_m) points.push_back(edges_[i].p_map);
  return points;
}

}  // namespace aisle
