#include "floor/wall_floor_edge_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "aisle/core/square.hpp"

namespace aisle {

namespace {

// Shares are of the image's width unless they say height.
constexpr double kNearPoint = 0.06;            // nearer to the vanishing point nothing can be distinguished
constexpr double kFloorPointTolerance = 0.02;  // of the height
constexpr double kCrossingMin = 0.05;          // of the height
constexpr double kLateral = 0.03;    // floor points nearer to the vanishing point's column are of the far end
constexpr double kDoor = 0.03;       // floor points nearer to each other are of one door
constexpr double kReflection = 0.6;  // share of its contrast that a line's reflection has at most
constexpr double kBorder_px = 4;     // a line that ends here is cut by the image's lower border
constexpr double kLookFrom = 0.025, kLookTo = 0.16;  // beside the line, for other edges
constexpr double kFloorStep_px = 8;                  // at a width of 640, over which floor changes little
constexpr double kFloorBeside = 1.25;                // cells to either side that are checked for floor ...
constexpr double kFloorBeneathBoard = 3;             // ... or beneath a board

/// Calls `visit` for points on the line from one end to the other.
template <class Visit>
void walk(double from_px, double to_px, double every_px, Visit visit) {
  const int steps = to_px < from_px ? -1 : static_cast<int>((to_px - from_px) / every_px);
  for (int i = 0; i <= steps; ++i) visit(from_px + i * every_px);
}

/// Calls `visit` for points where edges are seen on the line, with the step of grey levels there from above
/// the line to beneath it.
template <class Visit>
void walk_across(const SideView& view, const WallFloorEdge& edge, double every_px, double beside_px,
                 Visit visit) {
  const Vec2 beneath_px = beside_px * left_normal(edge.direction);
  walk(edge.from_px, edge.to_px, every_px, [&](double along_px) {
    const Vec2 on_px = edge.point_px + along_px * edge.direction;
    if (const auto step = view.step(on_px - beneath_px, on_px + beneath_px)) visit(on_px, *step);
  });
}

/// Share of the candidate's visible length that edges cover, from where the far end can be distinguished.
double covered_share(const SideScene& scene, const WallFloorEdge& edge) {
  const double width_px = scene.view.width_px();
  const double border_px = std::min((width_px - 1 - edge.point_px.x()) / edge.direction.x(),
                                    (scene.view.height_px() - 1 - edge.point_px.y()) / edge.direction.y());
  const double begin_px =
      edge.direction.dot(scene.vanishing_point_px - edge.point_px) + kNearPoint * width_px;
  return std::min(1.0, edge.covered * width_px / std::max(border_px - begin_px, 0.1 * width_px));
}

void weigh_contrast(const SideView& view, WallFloorEdge& edge) {
  constexpr double kEvery_px = 4, kBeside_px = 3;
  int count = 0;
  walk_across(view, edge, kEvery_px, kBeside_px, [&](const Vec2&, int step) {
    edge.contrast += std::abs(step);
    edge.sign += step;
    ++count;
  });
  if (count == 0) return;
  edge.contrast /= count;
  edge.sign /= count;
}

/// Mean step across a vertical line between two rows.
double contrast_along(const SideView& view, const SideVertical& vertical, double from_px, double to_px) {
  constexpr double kEvery_px = 4;
  const Vec2 beside_px(2, 0), down = vertical.bottom_px - vertical.top_px;
  double sum = 0;
  int count = 0;
  walk(from_px, to_px, kEvery_px, [&](double v_px) {
    const Vec2 on_px(vertical.top_px.x() + down.x() * (v_px - vertical.top_px.y()) / down.y(), v_px);
    const auto step = view.step(on_px - beside_px, on_px + beside_px);
    if (!step) return;
    sum += std::abs(*step);
    ++count;
  });
  return count == 0 ? 0 : sum / count;
}

/// How much a vertical line that goes on beneath the candidate, which it meets in row `v_px`, counts against
/// it: little if it is short, near the vanishing point, or hardly crosses. A line that is much fainter
/// beneath does not cross: what follows is its reflection.
double crossing(const SideScene& scene, const SideVertical& vertical, double v_px) {
  const double width_px = scene.view.width_px(), height_px = scene.view.height_px();
  const double tolerance_px = kFloorPointTolerance * height_px;
  const double above = contrast_along(scene.view, vertical, vertical.top_px.y(), v_px - tolerance_px);
  const double below = contrast_along(scene.view, vertical, v_px + tolerance_px, vertical.bottom_px.y());
  if (below < kReflection * above) return 0;
  const double length = (vertical.bottom_px.y() - vertical.top_px.y()) / height_px;
  const double lateral = (vertical.bottom_px.x() - scene.vanishing_point_px.x()) / width_px;
  const double beneath = (vertical.bottom_px.y() - v_px) / height_px;
  return std::min(1.0, lateral / 0.15) * std::min(1.0, length / 0.3) * std::min(1.0, below / 25) *
         std::min(1.0, beneath / 0.15);
}

/// Several lines of one door count as one floor point, with the weight of the best.
class FloorPoints {
 public:
  explicit FloorPoints(double door_px) : door_px_(door_px) {}

  void add(double u_px, double weight) {
    if (u_px > first_px_ + door_px_) {
      first_px_ = u_px;
      best_ = 0;
    }
    sum_ += std::max(0.0, weight - best_);
    best_ = std::max(best_, weight);
  }
  double sum() const { return sum_; }

 private:
  double door_px_;
  double first_px_ = -std::numeric_limits<double>::infinity();
  double best_ = 0, sum_ = 0;
};

void weigh_verticals(const SideScene& scene, WallFloorEdge& edge) {
  const double width_px = scene.view.width_px(), height_px = scene.view.height_px();
  FloorPoints floor_points(kDoor * width_px);
  for (const SideVertical& vertical : scene.verticals) {
    const double u_px = vertical.bottom_px.x(), v_px = edge.v_at(u_px);
    if (u_px < scene.vanishing_point_px.x() + kLateral * width_px) continue;
    if (vertical.top_px.y() > edge.v_at(vertical.top_px.x()) || v_px > height_px - kBorder_px) continue;
    const double beneath = (vertical.bottom_px.y() - v_px) / height_px;
    if (std::abs(beneath) < kFloorPointTolerance) {
      floor_points.add(u_px, vertical.weight * (1 - 0.5 * std::abs(beneath) / kFloorPointTolerance));
    } else if (beneath > kCrossingMin) {
      edge.crossings += crossing(scene, vertical, v_px);
    }
  }
  edge.floor_points = floor_points.sum();
}

/// The greatest step along the row from a point of the line towards the middle of the floor.
int greatest_step_beside(const SideScene& scene, const Vec2& on_px) {
  constexpr double kEvery_px = 3;
  const double width_px = scene.view.width_px();
  const double to_px = std::min(kLookTo * width_px, 0.6 * std::abs(on_px.x() - scene.vanishing_point_px.x()));
  const Vec2 step_px(std::round(kFloorStep_px * width_px / 640), 0);
  int greatest = 0;
  walk(kLookFrom * width_px, to_px, kEvery_px, [&](double lateral_px) {
    const Vec2 beside_px = on_px - Vec2(lateral_px, 0);
    if (const auto step = scene.view.step(beside_px - step_px, beside_px))
      greatest = std::max(greatest, std::abs(*step));
  });
  return greatest;
}

void weigh_floor_side(const SideScene& scene, WallFloorEdge& edge) {
  constexpr double kEvery_px = 6, kBeside_px = 4;
  int count = 0, followed = 0;
  walk_across(scene.view, edge, kEvery_px, kBeside_px, [&](const Vec2& on_px, int step) {
    ++count;
    if (greatest_step_beside(scene, on_px) > std::max(18.0, 0.8 * std::abs(step))) ++followed;
  });
  if (count > 0) edge.followed = static_cast<double>(followed) / count;
}

void weigh_floor(const SideScene& scene, WallFloorEdge& edge) {
  constexpr double kEvery_px = 6;
  const Vec2 beneath_px = scene.floor.cell_px() * left_normal(edge.direction);
  const auto is_floor = [&](const Vec2& p) {
    return scene.view.contains(p) && scene.floor.contain(scene.view, p);
  };
  int count = 0, on_floor = 0, at_edge = 0;
  walk(edge.from_px, edge.to_px, kEvery_px, [&](double along_px) {
    const Vec2 on_px = edge.point_px + along_px * edge.direction;
    const Vec2 lower_px = on_px + kFloorBeside * beneath_px, upper_px = on_px - kFloorBeside * beneath_px;
    if (!scene.view.contains(lower_px) || !scene.view.contains(upper_px)) return;
    ++count;
    if (!is_floor(lower_px) && !is_floor(on_px + kFloorBeneathBoard * beneath_px)) return;
    ++on_floor;
    if (!is_floor(upper_px)) ++at_edge;
  });
  if (count == 0) return;
  edge.on_floor = static_cast<double>(on_floor) / count;
  edge.at_edge = static_cast<double>(at_edge) / count;
}

}  // namespace

void weigh(const SideScene& scene, WallFloorEdge& edge) {
  edge.share = covered_share(scene, edge);
  weigh_contrast(scene.view, edge);
  weigh_verticals(scene, edge);
  weigh_floor_side(scene, edge);
  weigh_floor(scene, edge);
}

}  // namespace aisle
