#include "aisle/maps/floor_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace aisle {
namespace {

constexpr int kPassed = -1;
constexpr int kHit = 4;
constexpr int kSurelyFree = -10;
constexpr int kSeemsFree = 1 - kHit;
constexpr int kSeenFree = kSeemsFree - 1;  // or below: surely seen to be free
constexpr int kStands = 2 * kHit + 1;      // hit thrice
constexpr double kEdge_m = 0.1;            // by which hits of a wall's edge are off at most
constexpr int kDynamicHits = 20;  // more, and it stays: somebody who walks is in a cell for a third of that
constexpr int kGrowth = 128;      // cells added at once beyond the requested one

bool is_within_reach(FloorCell cell) {
  return std::abs(cell.x) <= FloorGrid::kReach && std::abs(cell.y) <= FloorGrid::kReach;
}

}  // namespace

void FloorBox::include(FloorCell cell) {
  const bool first = empty();
  low = first ? cell : FloorCell{std::min(low.x, cell.x), std::min(low.y, cell.y)};
  end = first ? FloorCell{cell.x + 1, cell.y + 1}
              : FloorCell{std::max(end.x, cell.x + 1), std::max(end.y, cell.y + 1)};
}

void FloorBox::include_box(const FloorBox& other) {
  if (other.empty()) return;
  include(other.low);
  include({other.end.x - 1, other.end.y - 1});
}

FloorBox FloorBox::common_with(const FloorBox& other) const {
  return {{std::max(low.x, other.low.x), std::max(low.y, other.low.y)},
          {std::min(end.x, other.end.x), std::min(end.y, other.end.y)}};
}

FloorBox FloorBox::widened(int cells) const {
  return {{low.x - cells, low.y - cells}, {end.x + cells, end.y + cells}};
}

FloorGrid::FloorGrid(double cell_m) : cell_m_(cell_m) {
  if (!(cell_m > 0)) throw std::invalid_argument("the cell size of a floor grid must be positive");
}

bool FloorGrid::see_free(FloorCell cell) {
  return weigh(cell, kPassed);
}

bool FloorGrid::see_occupied(FloorCell cell) {
  return weigh(cell, kHit);
}

bool FloorGrid::see_solid(FloorCell cell) {
  const bool was_free = evidence(cell) <= kSeenFree;
  return was_free && !is_beside_standing(cell) ? put_dynamic(cell, kDynamicOnce) : see_occupied(cell);
}

bool FloorGrid::seem_free(FloorCell cell) {
  if (at(cell) == Floor::kOccupied || evidence(cell) <= kSeemsFree) return false;
  return weigh(cell, kPassed);
}

bool FloorGrid::fade(FloorCell cell) {
  return evidence(cell) >= kSeemsFree && weigh(cell, kPassed);
}

bool FloorGrid::stand_on(FloorCell cell) {
  if (at(cell) == Floor::kOccupied) return see_free(cell);
  if (was_stood_on(cell) || !is_within_reach(cell)) return false;
  grow_to(cell);
  put(cell, kStoodOn);
  return true;
}

void FloorGrid::set(FloorCell cell, Floor floor) {
  const int evidence = floor == Floor::kFree ? kSurelyFree : floor == Floor::kOccupied ? kSurelyOccupied : 0;
  if (floor == Floor::kUnknown && !stored_.contains(cell)) return;
  if (!is_within_reach(cell)) return;
  grow_to(cell);
  put(cell, static_cast<Evidence>(evidence));
}

/// Hits of a wall's edge, off by the noise of scan or pose, are of nothing new.
bool FloorGrid::is_beside_standing(FloorCell cell) const {
  const int reach = static_cast<int>(std::lround(kEdge_m / cell_m_));
  for (int y = cell.y - reach; y <= cell.y + reach; ++y) {
    for (int x = cell.x - reach; x <= cell.x + reach; ++x) {
      const Evidence there = evidence({x, y});
      if (there >= kStands && there <= kSurelyOccupied) return true;
    }
  }
  return false;
}

FloorGrid::Evidence FloorGrid::weighed(int evidence, int weight) {
  const bool is_hit = weight > 0;
  if (evidence > kSurelyOccupied) {
    const int hits = evidence - kSurelyOccupied + (is_hit ? 1 : -1);
    if (hits > kDynamicHits) return kStands;
    return static_cast<Evidence>(hits == 0 ? kSeenFree : kSurelyOccupied + hits);
  }
  const int sum = std::clamp<int>(std::max(evidence, kSurelyFree) + weight, kSurelyFree, kSurelyOccupied);
  return static_cast<Evidence>(sum != 0 ? sum : is_hit ? 1 : -1);  // 0 means never seen
}

bool FloorGrid::weigh(FloorCell cell, int weight) {
  if (!is_within_reach(cell)) return false;
  grow_to(cell);
  if (weight < 0 && was_stood_on(cell)) return false;
  const Evidence weighed_now = weighed(evidence(cell), weight);
  const bool is_hit_dynamic = weight > 0 && weighed_now > kSurelyOccupied;
  return is_hit_dynamic ? put_dynamic(cell, weighed_now) : put(cell, weighed_now);
}

bool FloorGrid::put_dynamic(FloorCell cell, Evidence evidence) {
  dynamic_hit_s_[cell] = now_s_;
  return put(cell, evidence);
}

FloorBox FloorGrid::pass_time(double stamp_s) {
  now_s_ = stamp_s;
  return forget_dynamic_before(now_s_ - kForgotten_s);
}

FloorBox FloorGrid::forget_dynamic() {
  return forget_dynamic_before(std::numeric_limits<double>::infinity());
}

FloorBox FloorGrid::forget_dynamic_before(double forgotten_s) {
  FloorBox changed;
  for (auto it = dynamic_hit_s_.begin(); it != dynamic_hit_s_.end();) {
    const auto [cell, hit_s] = *it;
    const bool is_forgotten = is_dynamic(cell) && hit_s < forgotten_s;
    if (is_forgotten && put(cell, kSeenFree)) changed.include(cell);
    it = is_dynamic(cell) ? std::next(it) : dynamic_hit_s_.erase(it);
  }
  return changed;
}

bool FloorGrid::put(FloorCell cell, Evidence evidence) {
  Evidence& held = evidence_[index(cell)];
  const Floor before = floor_of(held), now = floor_of(evidence);
  held = evidence;
  if (before == now) return false;
  if (before != Floor::kUnknown) --counts_[static_cast<std::size_t>(before)];
  if (now != Floor::kUnknown) {
    ++counts_[static_cast<std::size_t>(now)];
    known_.include(cell);
  }
  return true;
}

/// Moves everything into a larger box if the cell lies outside the current one.
void FloorGrid::grow_to(FloorCell cell) {
  if (stored_.contains(cell)) return;
  FloorBox wider = stored_;
  const auto clamped = [](int coordinate) { return std::clamp(coordinate, -kReach, kReach); };
  for (const int growth : {-kGrowth, kGrowth}) {
    const bool grows_x = stored_.empty() || (growth < 0 ? cell.x < stored_.low.x : cell.x >= stored_.end.x);
    const bool grows_y = stored_.empty() || (growth < 0 ? cell.y < stored_.low.y : cell.y >= stored_.end.y);
    wider.include({clamped(cell.x + (grows_x ? growth : 0)), clamped(cell.y + (grows_y ? growth : 0))});
  }
  const FloorBox old_box = stored_;
  const std::vector<Evidence> old = std::move(evidence_);
  stored_ = wider;
  evidence_.assign(static_cast<std::size_t>(wider.end.x - wider.low.x) *
                       static_cast<std::size_t>(wider.end.y - wider.low.y),
                   0);
  const auto width = static_cast<std::size_t>(old_box.end.x - old_box.low.x);
  for (int row = old_box.low.y; row < old_box.end.y; ++row) {
    const auto from =
        old.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row - old_box.low.y) * width);
    std::copy(from, from + static_cast<std::ptrdiff_t>(width),
              evidence_.begin() + static_cast<std::ptrdiff_t>(index({old_box.low.x, row})));
  }
}

void FloorGrid::clear() {
  std::fill(evidence_.begin(), evidence_.end(), Evidence{0});
  std::fill(std::begin(counts_), std::end(counts_), std::size_t{0});
  known_ = {};
  dynamic_hit_s_.clear();
}

}  // namespace aisle
