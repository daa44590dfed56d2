#include "aisle/guidance/taught_edges.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kRasterCell_m = 0.05, kHalfWidth_m = 10;
constexpr int kRasterCells = 400;    // along a side
constexpr double kNearEnough_m = 1;  // the raster is kept for so much way

/// Across the line through points that lie on one; else zero.
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

int raster_cell(double from_low_m) {
  return static_cast<int>(std::floor(from_low_m / kRasterCell_m));
}

}  // namespace

TaughtEdges::TaughtEdges(const std::vector<RouteEdge>& edges, double reach_m) : reach_m_(reach_m) {
  constexpr double kNeighbours_m = 0.2, kIndexCell_m = 0.5;
  CellIndex index(kIndexCell_m);
  edges_.reserve(edges.size());
  for (const RouteEdge& edge : edges) {
    index.add({edge.p_map, edge.p_map}, static_cast<int>(edges_.size()));
    edges_.push_back({.along_m = edge.along_m, .p_map = edge.p_map});
  }
  std::stable_sort(edges_.begin(), edges_.end(),
                   [](const Edge& a, const Edge& b) { return a.along_m < b.along_m; });
  std::vector<int> near;
  std::vector<Vec2> points;
  for (Edge& edge : edges_) {
    index.query(edge.p_map, edge.p_map, kNeighbours_m, near);
    points.clear();
    for (const int i : near) {
      const Vec2& p = edges[static_cast<std::size_t>(i)].p_map;
      if ((p - edge.p_map).norm() < kNeighbours_m) points.push_back(p);
    }
    edge.normal = normal_of(points);
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

/// Enters an edge into the cells that it is the nearest to.
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
