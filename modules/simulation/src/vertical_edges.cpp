#include "aisle/simulation/vertical_edges.hpp"

#include <algorithm>
#include <cmath>

#include "prism.hpp"

namespace aisle {
namespace {

constexpr double kSamePlace_m = 0.005;
constexpr double kBend_rad = 5 * kDegree;  ///< walls that meet at a smaller angle are one

class Edges {
 public:
  void add(const Vec2& p_world, VerticalEdgeKind kind) { edges_.push_back({p_world, kind}); }

  void add(const Prism& prism, VerticalEdgeKind kind) {
    for (const Vec2& corner : prism.outline) add(corner, kind);
  }

  void add(const std::vector<Prism>& prisms, VerticalEdgeKind kind) {
    for (const Prism& prism : prisms) add(prism, kind);
  }

  std::vector<VerticalEdge> take() && { return std::move(edges_); }

 private:
  std::vector<VerticalEdge> edges_;
};

/// The end of a piece of wall, and where the wall goes from there.
struct WallEndPoint {
  Vec2 p_world = Vec2::Zero();
  double heading_rad = 0;
  double height_m = 0;
};

std::vector<WallEndPoint> ends_of(const std::vector<WallFace>& walls) {
  std::vector<WallEndPoint> ends;
  for (const WallFace& wall : walls) {
    ends.push_back({wall.floor_edge.start, wall.floor_edge.heading(), wall.height_m});
    ends.push_back({wall.floor_edge.end, wall.floor_edge.reversed().heading(), wall.height_m});
  }
  return ends;
}

/// Whether another wall of the same height continues straight where this one ends.
bool goes_on(const WallEndPoint& end, const std::vector<WallEndPoint>& ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const WallEndPoint& other) {
    return (other.p_world - end.p_world).norm() < kSamePlace_m && other.height_m == end.height_m &&
           std::abs(wrap_angle(other.heading_rad - end.heading_rad - kPi)) < kBend_rad;
  });
}

/// Where two walls meet in a corner, it is one edge.
void add_wall_ends(const std::vector<WallFace>& walls, Edges& edges) {
  const std::vector<WallEndPoint> ends = ends_of(walls);
  std::vector<Vec2> taken;
  for (const WallEndPoint& end : ends) {
    const bool is_taken = std::any_of(taken.begin(), taken.end(),
                                      [&](const Vec2& p) { return (p - end.p_world).norm() < kSamePlace_m; });
    if (is_taken || goes_on(end, ends)) continue;
    taken.push_back(end.p_world);
    edges.add(end.p_world, VerticalEdgeKind::kWall);
  }
}

void add_sides(const Poster& poster, Edges& edges) {
  const Vec2 half = poster.width_m / 2 * left_normal(unit(poster.facing_rad));
  edges.add(poster.centre - half, VerticalEdgeKind::kPoster);
  edges.add(poster.centre + half, VerticalEdgeKind::kPoster);
}

}  // namespace

std::vector<VerticalEdge> vertical_edges(const World& world) {
  Edges edges;
  std::vector<WallFace> seen_walls = world.walls;
  std::erase_if(seen_walls, [](const WallFace& wall) { return wall.is_glass(); });
  add_wall_ends(seen_walls, edges);
  for (const Door& door : world.doors) {
    edges.add(frame_posts_of(door), VerticalEdgeKind::kDoorFrame);
    if (door.open_rad != 0 || door.frame_width_m <= 0) edges.add(leaf_of(door), VerticalEdgeKind::kDoorLeaf);
  }
  for (const Poster& poster : world.posters) add_sides(poster, edges);
  for (const Furniture& piece : world.furniture) edges.add(parts_of(piece), VerticalEdgeKind::kFurniture);
  return std::move(edges).take();
}

}  // namespace aisle
