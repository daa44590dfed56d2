#include "aisle/exploration/floor_distances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

/// Steps to the neighbours in tenths of a cell, so that a queue of a few buckets orders them.
struct Step {
  int x;
  int y;
  unsigned tenths;
};
constexpr std::array<Step, 8> kSteps = {
    {{1, 0, 10}, {-1, 0, 10}, {0, 1, 10}, {0, -1, 10}, {1, 1, 14}, {1, -1, 14}, {-1, 1, 14}, {-1, -1, 14}}};

}  // namespace

void FloorDistances::measure(const FloorGrid& floor, const FloorClearance& clearance, const Vec2& from_m,
                             double room_m, double leeway_m) {
  room_ = clearance.room();
  cell_m_ = static_cast<float>(floor.cell_m());
  tenths_.assign(clearance.size(), kFar);
  const FloorCell start = floor.cell_at(from_m);
  if (!room_.widened(-1).contains(start)) return;
  queue_[0].push_back(index(start));
  tenths_[index(start)] = 0;
  const auto columns = static_cast<std::ptrdiff_t>(clearance.columns());
  const auto leeway = static_cast<std::uint32_t>(10 * leeway_m / floor.cell_m());
  std::size_t waiting = 1;
  for (std::uint32_t now = 0; waiting > 0; ++now) {
    bucket_.clear();
    bucket_.swap(queue_[now % kBuckets]);
    waiting -= bucket_.size();
    for (const std::size_t at : bucket_) {
      if (tenths_[at] != now) continue;
      for (const Step& step : kSteps) {
        const std::size_t next = at + static_cast<std::size_t>(step.y * columns + step.x);
        const std::uint32_t then = now + step.tenths;
        if (tenths_[next] <= then) continue;
        const double room = clearance.to_doubtful_m(next);
        if (room < room_m && (now > leeway || room <= 0)) continue;
        tenths_[next] = then;
        queue_[then % kBuckets].push_back(next);
        ++waiting;
      }
    }
  }
}

float FloorDistances::near(const FloorGrid& floor, const Vec2& p_map, double within_m) const {
  const FloorCell middle = floor.cell_at(p_map);
  const int reach = static_cast<int>(within_m / floor.cell_m());
  float nearest_m = kUnreached;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const auto beside_m = static_cast<float>(std::hypot(x, y) * floor.cell_m());
      nearest_m = std::min(nearest_m, to({middle.x + x, middle.y + y}) + beside_m);
    }
  }
  return nearest_m;
}

}  // namespace aisle
