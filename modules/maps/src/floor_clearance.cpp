#include "aisle/maps/floor_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr int kMargin = 32;  // cells of room beyond what is known

/// Exact distances to marked cells in a box, up to a limit: down and up the columns first, then along the
/// rows over at most as many cells as the limit holds.
class BoxDistances {
 public:
  /// @param in_column  to work with
  BoxDistances(const FloorBox& box, int limit, std::vector<int>& in_column)
      : box_(box),
        width_(box.end.x - box.low.x),
        height_(box.end.y - box.low.y),
        limit_(limit),
        in_column_(in_column) {
    in_column_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), limit);
  }

  template <class IsMarked>
  void mark(IsMarked is_marked) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const bool marked = is_marked(FloorCell{box_.low.x + x, box_.low.y + y});
        at(x, y) = marked ? 0 : y == 0 ? limit_ : std::min(limit_, at(x, y - 1) + 1);
      }
    }
    for (int y = height_ - 2; y >= 0; --y) {
      for (int x = 0; x < width_; ++x) at(x, y) = std::min(at(x, y), at(x, y + 1) + 1);
    }
  }

  /// In cells, from middle to middle.
  double distance(FloorCell cell) {
    const int x = cell.x - box_.low.x, y = cell.y - box_.low.y;
    int best = at(x, y) * at(x, y);
    for (int away = 1; away * away < best; ++away) {
      if (x >= away) best = std::min(best, away * away + at(x - away, y) * at(x - away, y));
      if (x + away < width_) best = std::min(best, away * away + at(x + away, y) * at(x + away, y));
    }
    return std::sqrt(best);
  }

 private:
  int& at(int x, int y) {
    return in_column_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x)];
  }

  FloorBox box_;
  int width_;
  int height_;
  int limit_;
  std::vector<int>& in_column_;
};

}  // namespace

void FloorClearance::bar(std::span<const Barrier> barriers, double cell_m) {
  for (const Barrier& barrier : barriers) {
    const std::vector<FloorCell> cells = cells_under(barrier.segment, cell_m);
    barred_.insert(barred_.end(), cells.begin(), cells.end());
  }
  std::sort(barred_.begin(), barred_.end(), is_before);
}

bool FloorClearance::is_barred(FloorCell cell) const {
  return std::binary_search(barred_.begin(), barred_.end(), cell, is_before);
}

/// Beyond the former room all is unknown as yet.
void FloorClearance::widen_room(const FloorBox& wider) {
  const FloorBox former = room_;
  const std::vector<float> former_doubtful_m = std::move(to_doubtful_m_);
  const std::vector<float> former_occupied_m = std::move(to_occupied_m_);
  room_.include_box(wider);
  const std::size_t size = columns() * static_cast<std::size_t>(room_.end.y - room_.low.y);
  to_doubtful_m_.assign(size, 0);
  to_occupied_m_.assign(size, static_cast<float>(far_m_));
  std::size_t number = 0;
  for_cells(former, [&](FloorCell, std::size_t wider_number) {
    to_doubtful_m_[wider_number] = former_doubtful_m[number];
    to_occupied_m_[wider_number] = former_occupied_m[number++];
  });
}

void FloorClearance::update(const FloorGrid& floor, const FloorBox& changed) {
  if (changed.empty()) return;
  const int limit = static_cast<int>(std::ceil(far_m_ / floor.cell_m())) + 1;
  FloorBox anew = changed;
  if (legs_) anew.include_box(legs_->update(floor, changed));
  anew = anew.widened(limit);
  const bool is_within = room_.contains(anew.low) && room_.contains({anew.end.x - 1, anew.end.y - 1});
  if (!is_within) {
    const bool is_first = room_.empty();
    widen_room(floor.known().widened(2 * kMargin));
    if (is_first || !barred_.empty()) anew = room_;
  }
  anew = anew.common_with(room_);
  BoxDistances doubtful(anew.widened(limit), limit, doubtful_cells_);
  BoxDistances occupied(anew.widened(limit), limit, occupied_cells_);
  doubtful.mark([&](FloorCell cell) { return floor.at(cell) != Floor::kFree || is_closed(cell); });
  occupied.mark([&](FloorCell cell) { return floor.at(cell) == Floor::kOccupied || is_closed(cell); });
  const auto metres = [&](double cells) {
    return static_cast<float>(std::clamp((cells - 0.5) * floor.cell_m(), 0.0, far_m_));
  };
  for (int y = anew.low.y; y < anew.end.y; ++y) {
    for (int x = anew.low.x; x < anew.end.x; ++x) {
      to_doubtful_m_[index({x, y})] = metres(doubtful.distance({x, y}));
      to_occupied_m_[index({x, y})] = metres(occupied.distance({x, y}));
    }
  }
}

}  // namespace aisle
