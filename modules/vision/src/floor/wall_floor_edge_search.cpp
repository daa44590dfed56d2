#include "floor/wall_floor_edge_search.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/principal_direction.hpp"

namespace aisle {

namespace {

// Shares are of the image's width unless they say height.
constexpr double kFlattest_rad = 8 * kDegree, kSteepest_rad = 78 * kDegree;
constexpr double kMissAngle = 0.09;  // sine of the angle by which a segment may miss the vanishing point
constexpr double kMissPerLength_px = 1.2;  // more for short segments
constexpr double kMissNear = 0.01;         // and more near the vanishing point
constexpr double kRayLengthMin = 0.02;
constexpr double kSeedLengthMin = 0.05;
constexpr double kSeedFloorPointWeightMin = 0.3;
constexpr double kFloorPointSeedLength_px = 12;
constexpr double kTrustedLength = 0.25;  // the direction of a seed this long is trusted
constexpr double kFirstTolerance = 0.008, kTolerance = 0.005;
constexpr double kFloorPointToleranceRatio = 1.5;  // how much more floor points may miss a line than rays
constexpr double kFloorPointWeight = 0.024;        // of a vertical line, as length of a ray
constexpr double kLowerBorder_px = 5;              // a vertical line that ends here is cut by the border
constexpr int kFits = 2;
constexpr double kPastPointMax = 0.05;  // how far a wall-floor edge may pass the vanishing point
constexpr int kBoards = 2;              // a board may stand on another
constexpr double kOtherEdge = 0.6;      // support of a board's lower edge, of that of the upper one
constexpr double kFreeFloor = 0.43;     // share of a board's lower edge beneath which other edges may come
constexpr double kLikeScore = 0.7;
constexpr double kBoardMin = 0.004;      // height of a board, as seen ...
constexpr double kBoardDepthMax = 1.25;  // ... and at most: a fifth of the camera's height
constexpr double kDepthLateral = 0.3;    // where heights are compared

bool is_possible(const SideScene& scene, const WallFloorEdge& edge) {
  const double angle = std::atan2(edge.direction.y(), edge.direction.x());
  if (angle < kFlattest_rad || angle > kSteepest_rad) return false;
  const double past_px = std::abs(cross(edge.direction, scene.vanishing_point_px - edge.point_px));
  return past_px <= kPastPointMax * scene.view.width_px();
}

/// How far beneath the vanishing point a line is in a column to the right of it.
double depth_px(const SideScene& scene, const WallFloorEdge& edge) {
  return edge.v_at(scene.vanishing_point_px.x() + kDepthLateral * scene.view.width_px()) -
         scene.vanishing_point_px.y();
}

/// Whether `edge` may be the lower edge of the skirting board whose upper edge is `upper`.
bool is_lower_edge(const SideScene& scene, const WallFloorEdge& edge, const WallFloorEdge& upper) {
  if (!edge.has_clear_sign()) return false;
  const bool opposite_step = edge.support() > kOtherEdge * upper.support() && edge.followed < kFreeFloor &&
                             edge.sign * upper.sign < 0;
  if (edge.score() < kLikeScore * upper.score() && !opposite_step) return false;
  const double depth = depth_px(scene, edge), upper_depth = depth_px(scene, upper);
  return depth > upper_depth + kBoardMin * scene.view.width_px() && depth < kBoardDepthMax * upper_depth;
}

}  // namespace

/// Moments of weighted points, for a line through them.
struct WallFloorEdgeSearch::Scatter {
  double weight = 0;
  Vec2 sum = Vec2::Zero();
  Mat2 products = Mat2::Zero();

  void add(const Vec2& point_px, double w) {
    weight += w;
    sum += w * point_px;
    products += w * point_px * point_px.transpose();
  }

  /// Through the points' middle, and along them where they lie apart.
  void lay(WallFloorEdge& edge) const {
    const Vec2 mean_px = sum / weight;
    const Mat2 spread = products / weight - mean_px * mean_px.transpose();
    edge.point_px = mean_px;
    if (spread.trace() <= 1) return;
    const Vec2 along = principal_direction(spread);
    edge.direction = along.dot(edge.direction) < 0 ? Vec2(-along) : along;
  }
};

std::optional<WallFloorEdge> WallFloorEdgeSearch::find(const SideScene& scene,
                                                       std::span<const EdgeSegment> segments,
                                                       double score_min) {
  gather_rays(scene, segments);
  gather_seeds(scene);
  edges_.clear();
  for (const Seed& seed : seeds_) {
    auto edge = fitted(scene, seed);
    if (!edge || !is_possible(scene, *edge)) continue;
    weigh(scene, *edge);
    edges_.push_back(*edge);
  }
  const WallFloorEdge* best = lowest_of_like_score(scene, score_min);
  if (best == nullptr) return std::nullopt;
  return *best;
}

void WallFloorEdgeSearch::gather_rays(const SideScene& scene, std::span<const EdgeSegment> segments) {
  const double width_px = scene.view.width_px(), height_px = scene.view.height_px();
  rays_.clear();
  for (const EdgeSegment& segment : segments) {
    const Vec2 from_px = segment.middle_px() - scene.vanishing_point_px;
    if (from_px.x() < 0.02 * width_px || from_px.y() < 0.015 * height_px) continue;
    const double length_px = segment.length_px();
    if (length_px < kRayLengthMin * width_px) continue;
    const double angle = std::atan2(from_px.y(), from_px.x());
    if (angle < kFlattest_rad || angle > kSteepest_rad) continue;
    const double miss = std::abs(cross(from_px, segment.direction())) / from_px.norm();
    if (miss > kMissAngle + kMissPerLength_px / length_px + kMissNear * width_px / from_px.norm()) continue;
    rays_.push_back(segment);
  }
}

/// Long rays, and rays to the lower ends of vertical lines: where doors hide the wall-floor edge, there are
/// only these.
void WallFloorEdgeSearch::gather_seeds(const SideScene& scene) {
  const double width_px = scene.view.width_px(), height_px = scene.view.height_px();
  seeds_.clear();
  for (const EdgeSegment& ray : rays_) {
    if (ray.length_px() < kSeedLengthMin * width_px) continue;
    seeds_.push_back({ray.middle_px(), ray.direction(), ray.length_px()});
  }
  for (const SideVertical& vertical : scene.verticals) {
    const Vec2 from_px = vertical.bottom_px - scene.vanishing_point_px;
    if (vertical.weight < kSeedFloorPointWeightMin || vertical.bottom_px.y() > height_px - kLowerBorder_px)
      continue;
    if (from_px.x() < 0.03 * width_px || from_px.y() < 0.06 * height_px) continue;
    seeds_.push_back({vertical.bottom_px, from_px.normalized(), kFloorPointSeedLength_px});
  }
}

/// The line through the seed, fitted to the rays and floor points near it.
std::optional<WallFloorEdge> WallFloorEdgeSearch::fitted(const SideScene& scene, const Seed& seed) {
  const double width_px = scene.view.width_px();
  const double trust = std::min(1.0, seed.length_px / (kTrustedLength * width_px));
  const Vec2 from_vanishing_point = (seed.point_px - scene.vanishing_point_px).normalized();
  WallFloorEdge edge;
  edge.point_px = seed.point_px;
  edge.direction = (trust * seed.direction + (1 - trust) * from_vanishing_point).normalized();
  for (int fit = 0; fit < kFits; ++fit) {
    const Scatter near = take_near(scene, edge, (fit == 0 ? kFirstTolerance : kTolerance) * width_px);
    if (near.weight <= 0) return std::nullopt;
    near.lay(edge);
  }
  take_near(scene, edge, kTolerance * width_px);
  if (near_px_.empty()) return std::nullopt;
  cover(width_px, edge);
  return edge;
}

/// The rays and floor points on a line; of the rays also where they lie on it (`near_px_`).
WallFloorEdgeSearch::Scatter WallFloorEdgeSearch::take_near(const SideScene& scene, const WallFloorEdge& edge,
                                                            double tolerance_px) {
  const double width_px = scene.view.width_px(), height_px = scene.view.height_px();
  const auto off_px = [&](const Vec2& point_px) {
    return std::abs(cross(edge.direction, point_px - edge.point_px));
  };
  const auto along_px = [&](const Vec2& point_px) { return edge.direction.dot(point_px - edge.point_px); };
  Scatter scatter;
  near_px_.clear();
  for (const EdgeSegment& ray : rays_) {
    if (off_px(ray.left_px) > tolerance_px || off_px(ray.right_px) > tolerance_px) continue;
    for (const Vec2& point_px : {ray.left_px, ray.middle_px(), ray.right_px})
      scatter.add(point_px, ray.length_px());
    near_px_.emplace_back(along_px(ray.left_px), along_px(ray.right_px));
  }
  for (const SideVertical& vertical : scene.verticals) {
    if (off_px(vertical.bottom_px) > kFloorPointToleranceRatio * tolerance_px) continue;
    if (vertical.bottom_px.y() > height_px - kLowerBorder_px) continue;
    scatter.add(vertical.bottom_px, kFloorPointWeight * width_px * vertical.weight);
  }
  return scatter;
}

/// Notes where rays are seen on a line, each length of it once.
void WallFloorEdgeSearch::cover(double width_px, WallFloorEdge& edge) {
  std::sort(near_px_.begin(), near_px_.end());
  double covered_px = 0, end_px = near_px_.front().first;
  for (const auto& [from_px, to_px] : near_px_) {
    covered_px += std::max(0.0, to_px - std::max(from_px, end_px));
    end_px = std::max(end_px, to_px);
  }
  edge.from_px = near_px_.front().first;
  edge.to_px = end_px;
  edge.covered = covered_px / width_px;
}

/// A skirting board has two edges; the lower one is at the floor.
const WallFloorEdge* WallFloorEdgeSearch::lowest_of_like_score(const SideScene& scene,
                                                               double score_min) const {
  const auto better = [](const WallFloorEdge& a, const WallFloorEdge& b) { return a.score() < b.score(); };
  const auto best_at = std::max_element(edges_.begin(), edges_.end(), better);
  if (best_at == edges_.end() || best_at->score() < score_min) return nullptr;
  const WallFloorEdge* best = &*best_at;
  for (int board = 0; board < kBoards; ++board) {
    const WallFloorEdge* lowest = best;
    for (const WallFloorEdge& edge : edges_) {
      if (!is_lower_edge(scene, edge, *best)) continue;
      if (lowest == best || depth_px(scene, edge) > depth_px(scene, *lowest)) lowest = &edge;
    }
    if (lowest == best) break;
    best = lowest;
  }
  return best;
}

}  // namespace aisle
