#pragma once
/// Buildings drawn as rectangles of free floor, as somebody saw them who was in all of them or in a part.

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "aisle/maps/building.hpp"

namespace aisle::drawn {

using Rect = Eigen::AlignedBox2d;

inline Rect rect(double x0, double y0, double x1, double y1) {
  return {Vec2(x0, y0), Vec2(x1, y1)};
}

inline constexpr double kCell_m = 0.05;

/// Free floor as the union of rectangles, in cells.
class Plan {
 public:
  explicit Plan(std::vector<Rect> free, std::vector<Rect> solid = {})
      : free_(std::move(free)), solid_(std::move(solid)) {}

  bool is_free(int x, int y) const {
    const Vec2 p = kCell_m * Vec2(x + 0.5, y + 0.5);
    return is_in(free_, p) && !is_in(solid_, p);
  }
  Rect box() const {
    Rect all;
    for (const Rect& one : free_) all.extend(one);
    return all;
  }

 private:
  static bool is_in(const std::vector<Rect>& rects, const Vec2& p) {
    for (const Rect& one : rects) {
      if (one.contains(p)) return true;
    }
    return false;
  }

  std::vector<Rect> free_, solid_;
};

/// The faces along one row of cell edges: each run of edges with free floor on one side only is a wall.
template <class IsFree, class PointAt>
void add_faces(int first, int end, IsFree is_free, PointAt at, std::vector<Wall>& walls) {
  for (const bool above : {false, true}) {
    int begun = first;
    bool is_on = false;
    for (int i = first; i <= end; ++i) {
      const bool is_face = i < end && is_free(i, above) && !is_free(i, !above);
      if (is_face == is_on) continue;
      if (is_face) begun = i;
      if (!is_face) {
        const Segment2 face{at(begun), at(i)};
        walls.push_back({.segment = above ? face : face.reversed(),
                         .is_orthogonal = true,
                         .sightings = 5,
                         .sigma_m = 0.01});
      }
      is_on = is_face;
    }
  }
}

/// What a vehicle knows of the building that has only seen what lies in `seen`.
inline Building known(const Plan& plan, const Rect& seen) {
  Building building{.name = "drawn", .has_dominant_direction = true};
  building.floor.emplace(kCell_m);
  const auto cell = [](double m) { return static_cast<int>(std::lround(m / kCell_m)); };
  const Rect box = plan.box().intersection(seen);
  const int x0 = cell(box.min().x()), x1 = cell(box.max().x()), y0 = cell(box.min().y()),
            y1 = cell(box.max().y());
  for (int y = y0; y <= y1; ++y) {
    add_faces(
        x0, x1, [&](int x, bool above) { return plan.is_free(x, above ? y : y - 1); },
        [&](int x) { return Vec2(kCell_m * x, kCell_m * y); }, building.walls.walls);
  }
  for (int x = x0; x <= x1; ++x) {
    add_faces(
        y0, y1, [&](int y, bool left) { return plan.is_free(left ? x - 1 : x, y); },
        [&](int y) { return Vec2(kCell_m * x, kCell_m * y); }, building.walls.walls);
  }
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      if (plan.is_free(x, y)) building.floor->set({x, y}, Floor::kFree);
    }
  }
  return building;
}

inline Building known(const Plan& plan) {
  return known(plan, rect(-1000, -1000, 1000, 1000));
}

/// A corridor of 30 m with rooms of many sizes, no two alike.
inline std::vector<Rect> office() {
  return {rect(0, 0, 30, 2),          rect(1, 2, 2, 2.2),    rect(0, 2.2, 4, 6),        rect(6, 2, 7, 2.2),
          rect(4.2, 2.2, 10, 5),      rect(13, 2, 14, 2.2),  rect(10.2, 2.2, 15, 7),    rect(19, 2, 20, 2.2),
          rect(15.2, 2.2, 22, 4.4),   rect(25, 2, 26, 2.2),  rect(22.2, 2.2, 28, 8),    rect(4, -0.2, 5, 0),
          rect(2, -5, 8, -0.2),       rect(11, -0.2, 12, 0), rect(8.2, -3.4, 14, -0.2), rect(17, -0.2, 18, 0),
          rect(14.2, -6, 19.4, -0.2), rect(23, -0.2, 24, 0), rect(19.6, -4.2, 27, -0.2)};
}

}  // namespace aisle::drawn
