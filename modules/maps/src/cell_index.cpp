#include "aisle/maps/cell_index.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

template <class Visit>
void CellIndex::for_each_cell(const Vec2& low, const Vec2& high, Visit visit) const {
  const auto cell_of = [this](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / cell_m_));
  };
  for (std::int64_t column = cell_of(low.x()); column <= cell_of(high.x()); ++column) {
    for (std::int64_t row = cell_of(low.y()); row <= cell_of(high.y()); ++row) {
      visit(column * (std::int64_t{1} << 32) + row);
    }
  }
}

void CellIndex::add(const Segment2& segment, int id) {
  const auto pieces = static_cast<int>(std::ceil(segment.length() / cell_m_)) + 1;
  const Vec2 step = (segment.end - segment.start) / pieces;
  for (int i = 0; i < pieces; ++i) {  // the cells of each short piece's box: a few too many, never too few
    const Vec2 from = segment.start + i * step, to = from + step;
    for_each_cell(from.cwiseMin(to), from.cwiseMax(to), [&](std::int64_t cell) {
      std::vector<int>& ids = cells_[cell];
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    });
  }
}

void CellIndex::query(const Vec2& corner, const Vec2& opposite, double margin_m,
                      std::vector<int>& ids) const {
  ids.clear();
  const Vec2 low = corner.cwiseMin(opposite).array() - margin_m;
  const Vec2 high = corner.cwiseMax(opposite).array() + margin_m;
  for_each_cell(low, high, [&](std::int64_t cell) {
    const auto found = cells_.find(cell);
    if (found != cells_.end()) ids.insert(ids.end(), found->second.begin(), found->second.end());
  });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace aisle
