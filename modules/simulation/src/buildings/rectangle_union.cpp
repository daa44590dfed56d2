#include "buildings/rectangle_union.hpp"

#include <algorithm>
#include <cmath>

#include "plans/cell_outlines.hpp"

namespace aisle {
namespace {

long millimetres(double value_m) {
  return std::lround(value_m * 1000);
}

/// The different coordinates along one axis, in millimetres.
class Rulings {
 public:
  void add(double value_m) { values_.push_back(millimetres(value_m)); }

  void sort() {
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
  }

  int index(double value_m) const {
    return static_cast<int>(std::lower_bound(values_.begin(), values_.end(), millimetres(value_m)) -
                            values_.begin());
  }
  int spaces() const { return static_cast<int>(values_.size()) - 1; }
  double metres(int index) const {
    return static_cast<double>(values_[static_cast<std::size_t>(index)]) / 1000;
  }

 private:
  std::vector<long> values_;
};

}  // namespace

std::vector<Segment2> walls_around(std::span<const Rectangle> rectangles) {
  std::vector<Segment2> walls;
  if (rectangles.empty()) return walls;
  Rulings columns, rows;
  for (const Rectangle& r : rectangles) {
    for (const Vec2& corner : {r.min, r.max}) {
      columns.add(corner.x());
      rows.add(corner.y());
    }
  }
  columns.sort();
  rows.sort();
  FloorPlan plan(columns.spaces(), rows.spaces(), 1);
  for (const Rectangle& r : rectangles) {
    for (int y = rows.index(r.min.y()); y < rows.index(r.max.y()); ++y) {
      for (int x = columns.index(r.min.x()); x < columns.index(r.max.x()); ++x)
        plan.solid[plan.index(x, y)] = 0;
    }
  }
  const auto point = [&](const LatticePoint& p) { return Vec2(columns.metres(p.x), rows.metres(p.y)); };
  for (const Outline& outline : cell_outlines(plan)) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      walls.push_back({point(outline[i]), point(outline[(i + 1) % outline.size()])});
    }
  }
  return walls;
}

}  // namespace aisle
