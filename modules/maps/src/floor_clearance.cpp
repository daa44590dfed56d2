#include "aisle/maps/floor_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr int kMargin = 32;  // cells stored beyond the known box

/// Exact distances to marked cells in a box, up to a limit: first down and up the columns, then along the
/// rows over as many cells as the limit allows. Works on whole rows, in loops without branches.
class BoxDistances {
 public:
  /// @param in_column  scratch memory
  BoxDistances(const FloorBox& box, int limit, std::vector<int>& in_column)
      : box_(box),
        width_(box.end.x - box.low.x),
        limit_(limit),
        in_column_(in_column),
        squared_(static_cast<std::size_t>(width_ + 2 * limit), limit * limit) {
    in_column_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(box.end.y - box.low.y));
  }

  template <class IsMarked>
  void mark(IsMarked is_marked) {
    for (int y = box_.low.y; y < box_.end.y; ++y) {
      int* cells = row(y);
      for (int x = 0; x < width_; ++x) cells[x] = is_marked(FloorCell{box_.low.x + x, y}) ? 0 : limit_;
    }
  }

  void mark_cells(std::span<const FloorCell> cells) {
    for (const FloorCell cell : cells) {
      if (box_.contains(cell)) row(cell.y)[cell.x - box_.low.x] = 0;
    }
  }

  /// To be called after all marks.
  void measure_columns() {
    for (int y = box_.low.y + 1; y < box_.end.y; ++y) go_on(row(y - 1), row(y));
    for (int y = box_.end.y - 2; y >= box_.low.y; --y) go_on(row(y + 1), row(y));
  }

  /// Visits the cells of a row from `low_x` up to but not including `end_x`, each with its squared distance
  /// [cells, from centre to centre].
  template <class Visit>
  void measure_row(int y, int low_x, int end_x, Visit visit) {
    const int* cells = row(y);
    for (int x = 0; x < width_; ++x) squared_[static_cast<std::size_t>(x + limit_)] = cells[x] * cells[x];
    for (int x = low_x; x < end_x; x += kAtOnce) {
      const int* middle = squared_.data() + limit_ + (x - box_.low.x);
      const int count = std::min(kAtOnce, end_x - x);
      int nearest2[kAtOnce];
      std::copy(middle, middle + count, nearest2);
      int farthest2 = limit_ * limit_;
      for (int away = 1; away * away < farthest2; ++away) {
        farthest2 = 0;
        for (int i = 0; i < count; ++i) {
          nearest2[i] = std::min(nearest2[i], away * away + std::min(middle[i - away], middle[i + away]));
          farthest2 = std::max(farthest2, nearest2[i]);
        }
      }
      for (int i = 0; i < count; ++i) visit(FloorCell{x + i, y}, nearest2[i]);
    }
  }

 private:
  static constexpr int kAtOnce = 32;  // cells of a row at once while one of them is far from all marks

  void go_on(const int* from, int* to) const {
    for (int x = 0; x < width_; ++x) to[x] = std::min(to[x], from[x] + 1);
  }

  int* row(int y) {
    return in_column_.data() + static_cast<std::size_t>(y - box_.low.y) * static_cast<std::size_t>(width_);
  }

  FloorBox box_;
  int width_;
  int limit_;
  std::vector<int>& in_column_;
  std::vector<int> squared_;  ///< of one row and its surroundings
};

}  // namespace

void FloorClearance::bar(std::span<const Barrier> barriers, double cell_m) {
  for (const Barrier& barrier : barriers) {
    const std::vector<FloorCell> cells = cells_under(barrier.segment, cell_m);
    barred_.insert(barred_.end(), cells.begin(), cells.end());
  }
  std::sort(barred_.begin(), barred_.end());
}

bool FloorClearance::is_barred(FloorCell cell) const {
  return std::binary_search(barred_.begin(), barred_.end(), cell);
}

/// Outside the previous box everything is unknown so far.
void FloorClearance::widen_stored(const FloorBox& wider) {
  const FloorBox former = stored_;
  const std::vector<float> former_doubtful_m = std::move(to_doubtful_m_);
  const std::vector<float> former_occupied_m = std::move(to_occupied_m_);
  stored_.include_box(wider);
  const std::size_t size = columns() * static_cast<std::size_t>(stored_.end.y - stored_.low.y);
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
  FloorBox affected = changed;
  if (legs_) affected.include_box(legs_->update(floor, changed));
  affected = affected.widened(limit);
  const bool is_within =
      stored_.contains(affected.low) && stored_.contains({affected.end.x - 1, affected.end.y - 1});
  if (!is_within) {
    const bool is_first = stored_.empty();
    widen_stored(floor.known().widened(2 * kMargin));
    if (is_first || !barred_.empty()) affected = stored_;
  }
  affected = affected.common_with(stored_);
  std::vector<float> metres;  // by squared distance
  for (int squared = 0; squared <= limit * limit; ++squared)
    metres.push_back(
        static_cast<float>(std::clamp((std::sqrt(squared) - 0.5) * floor.cell_m(), 0.0, far_m_)));
  const auto measure = [&](auto is_marked, std::vector<float>& to_marked_m) {
    BoxDistances distances(affected.widened(limit), limit, in_column_);
    distances.mark(is_marked);
    if (legs_) distances.mark_cells(legs_->closed());
    distances.mark_cells(barred_);
    distances.measure_columns();
    for (int y = affected.low.y; y < affected.end.y; ++y) {
      distances.measure_row(y, affected.low.x, affected.end.x, [&](FloorCell cell, int squared) {
        to_marked_m[index(cell)] = metres[static_cast<std::size_t>(squared)];
      });
    }
  };
  measure([&](FloorCell cell) { return floor.at(cell) != Floor::kFree; }, to_doubtful_m_);
  measure([&](FloorCell cell) { return floor.at(cell) == Floor::kOccupied; }, to_occupied_m_);
}

}  // namespace aisle
