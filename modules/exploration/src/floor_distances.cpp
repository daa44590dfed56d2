#include "aisle/exploration/floor_distances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

/// Steps to the eight neighbours, counter-clockwise from the right. In tenths of a cell, distances are
/// integers that a queue of a few buckets can sort.
constexpr std::array<FloorCell, 8> kSteps = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr std::int32_t kStraight = 10;
constexpr std::int32_t kDiagonal = 14;

constexpr bool is_diagonal(unsigned step) {
  return step % 2 == 1;
}

}  // namespace

void FloorDistances::measure(const KnownFloor& floor, const Vec2& from_m, double clearance_m, double leeway_m,
                             Paths paths) {
  const FloorGrid& grid = floor.grid();
  const FloorClearance& clearance = floor.clearance();
  box_ = clearance.room();
  cell_m_ = static_cast<float>(grid.cell_m());
  const auto has_clearance = [&](std::size_t at) { return clearance.to_doubtful_m(at) >= clearance_m; };
  tenths_.resize(clearance.size());
  for (std::size_t at = 0; at < tenths_.size(); ++at) tenths_[at] = has_clearance(at) ? kFar : kShut;
  start_ = grid.cell_at(from_m);
  if (!box_.widened(-1).contains(start_)) return;
  const auto leeway = static_cast<std::int32_t>(10 * leeway_m / grid.cell_m());
  FloorBox about;
  about.include(start_);
  about = about.widened((leeway + 2 * kDiagonal) / 10);
  clearance.for_cells(about, [&](FloorCell, std::size_t at) {
    if (clearance.to_doubtful_m(at) > 0) tenths_[at] = kFar;
  });
  for (std::size_t step = 0; step < kSteps.size(); ++step)
    to_next_[step] = kSteps[step].y * static_cast<std::ptrdiff_t>(clearance.columns()) + kSteps[step].x;
  begin_at(index(start_));
  // cells with less clearance are entered only within the leeway: all of them are settled one step beyond it
  settle(leeway + kDiagonal, [&](Reached reached) {
    for (unsigned step = 0; step < kSteps.size(); ++step) {
      if (now_ <= leeway || has_clearance(next(reached.at, step))) go(reached.at, step);
    }
  });
  clearance.for_cells(about, [&](FloorCell, std::size_t at) {
    if (tenths_[at] == kFar && !has_clearance(at)) tenths_[at] = kShut;
  });
  if (floor.is_one_way_somewhere())
    settle(kFar, [&](Reached reached) { go_where_allowed(floor, reached, paths); });
  else
    settle(kFar, [this](Reached reached) { go_on(reached); });
}

void FloorDistances::begin_at(std::size_t start) {
  now_ = 0;
  waiting_ = 1;
  tenths_[start] = 0;
  queue_[0].push_back({static_cast<std::uint32_t>(start), 0});
}

/// Settles all cells up to a distance, in tenths of a cell, nearest first.
template <class Leave>
void FloorDistances::settle(std::int32_t until, Leave leave) {
  for (; waiting_ > 0 && now_ <= until; ++now_) {
    bucket_.clear();
    bucket_.swap(queue_[static_cast<std::size_t>(now_) % kBuckets]);
    waiting_ -= bucket_.size();
    for (const Reached reached : bucket_) {
      if (tenths_[reached.at] == now_) leave(reached);
    }
  }
}

inline void FloorDistances::go(std::size_t from, unsigned step) {
  const std::size_t at = next(from, step);
  const std::int32_t then = now_ + (is_diagonal(step) ? kDiagonal : kStraight);
  if (tenths_[at] <= then) return;
  tenths_[at] = then;
  queue_[static_cast<std::size_t>(then) % kBuckets].push_back(
      {static_cast<std::uint32_t>(at), static_cast<std::uint8_t>(step)});
  ++waiting_;
}

/// Goes on in the latest step's direction and around what stands beside it; every other cell is no farther
/// from the previous cell (as in jump point search).
inline void FloorDistances::go_on(Reached reached) {
  const unsigned ahead = reached.by, beside = is_diagonal(ahead) ? 3 : 2;
  const auto is_shut = [&](unsigned step) { return tenths_[next(reached.at, step)] == kShut; };
  go(reached.at, ahead);
  if (is_diagonal(ahead)) {
    go(reached.at, (ahead + 1) % kSteps.size());
    go(reached.at, (ahead + 7) % kSteps.size());
  }
  const unsigned left = (ahead + beside) % kSteps.size(), right = (ahead + 8 - beside) % kSteps.size();
  if (is_shut(left)) go(reached.at, (left + 7) % kSteps.size());
  if (is_shut(right)) go(reached.at, (right + 1) % kSteps.size());
}

/// Goes on to all neighbours between which and here a vehicle may drive.
void FloorDistances::go_where_allowed(const KnownFloor& floor, Reached reached, Paths paths) {
  const auto columns = static_cast<std::size_t>(box_.end.x - box_.low.x);
  const FloorCell here{box_.low.x + static_cast<int>(reached.at % columns),
                       box_.low.y + static_cast<int>(reached.at / columns)};
  const Vec2 p_map = floor.grid().centre(here);
  for (unsigned step = 0; step < kSteps.size(); ++step) {
    const FloorCell away = paths == Paths::kFromStart ? kSteps[step] : kSteps[(step + 4) % kSteps.size()];
    const double driven_rad = std::atan2(away.y, away.x);
    if (floor.may_drive({p_map.x(), p_map.y(), driven_rad}, Gear::kForward)) go(reached.at, step);
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
