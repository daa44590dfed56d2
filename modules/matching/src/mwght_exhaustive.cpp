#include "mwght_exhaustive.hpp"

#include <algorithm>

namespace aisle {

void MwghtArray::vote(const MwghtVotes& votes, const MwghtGrid& grid, const MwghtKernel& kernel) {
  grid_ = grid;
  values_.assign(static_cast<std::size_t>(grid.turns()) * static_cast<std::size_t>(grid.rows()) *
                     static_cast<std::size_t>(grid.columns()),
                 0.0);
  const int reach = kernel.reach();
  for (int turn = 0; turn < grid.turns(); ++turn) {
    for (const MwghtVote& vote : votes.of_turn(turn)) {
      const int x_first = std::max(0, vote.x - reach), x_last = std::min(grid.columns() - 1, vote.x + reach);
      const int y_first = std::max(0, vote.y - reach), y_last = std::min(grid.rows() - 1, vote.y + reach);
      for (int y = y_first; y <= y_last; ++y) {
        double* const cells = row(turn, y);
        const double* const shares = kernel.row(y - vote.y);
        for (int x = x_first; x <= x_last; ++x)
          cells[x] += vote.weight * shares[x - vote.x + reach];  // eq. (6)
      }
    }
  }
}

std::optional<MwghtMaximum> MwghtArray::maximum(const MwghtVicinity* excluded) const {
  std::optional<MwghtMaximum> best;
  double best_value = 0;
  std::size_t i = 0;
  for (int turn = 0; turn < grid_.turns(); ++turn) {
    for (int y = 0; y < grid_.rows(); ++y) {
      for (int x = 0; x < grid_.columns(); ++x, ++i) {
        if (values_[i] <= best_value) continue;
        const MwghtCell cell = grid_.cell(turn, y, x);
        if (excluded && excluded->holds(cell)) continue;
        best_value = values_[i];
        best = {cell, best_value};
      }
    }
  }
  return best;
}

}  // namespace aisle
