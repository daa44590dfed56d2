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
constexpr std::size_t kBuckets = 16;

}  // namespace

void FloorDistances::measure(const FloorGrid& floor, const FloorClearance& clearance, const Vec2& from_m,
                             double room_m, double leeway_m) {
  room_ = clearance.room();
  distances_m_.assign(clearance.size(), kUnreached);
  const FloorCell start = floor.cell_at(from_m);
  if (!room_.contains(start)) return;
  std::array<std::vector<std::size_t>, kBuckets> queue;
  std::vector<std::uint32_t> tenths(clearance.size(), UINT32_MAX);
  const auto reach = [&](FloorCell cell, std::uint32_t distance) {
    const std::size_t at = clearance.index(cell);
    if (distance >= tenths[at]) return false;
    tenths[at] = distance;
    queue[distance % kBuckets].push_back(at);
    return true;
  };
  reach(start, 0);
  const auto leeway = static_cast<std::uint32_t>(10 * leeway_m / floor.cell_m());
  std::size_t waiting = 1;
  for (std::uint32_t now = 0; waiting > 0; ++now) {
    std::vector<std::size_t> bucket = std::move(queue[now % kBuckets]);
    queue[now % kBuckets].clear();
    waiting -= bucket.size();
    for (const std::size_t at : bucket) {
      if (tenths[at] != now) continue;
      const FloorCell cell = clearance.cell(at);
      distances_m_[at] = static_cast<float>(now) * 0.1F * static_cast<float>(floor.cell_m());
      for (const Step& step : kSteps) {
        const FloorCell next{cell.x + step.x, cell.y + step.y};
        const double room = clearance.to_doubtful_m(next);
        if (room < room_m && (now > leeway || room <= 0)) continue;
        if (reach(next, now + step.tenths)) ++waiting;
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
