#include "mwght_search.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr int kCoarse = 16, kFine = 4;  // cells along a square's side
constexpr double kFloatStep = 1.0 / (1 << 22);
constexpr double kFloatFloor = 1e-30;  // of sums of shares: below, products may have vanished

using Bounds4x4 = Eigen::Array44f;

/// Squares that one vote can reach, along an axis.
int squares_reached(int reach) {
  return (2 * reach + kCoarse - 1) / kCoarse + 1;
}

/// Keeps the votes, in their order, that reach into the square of `size` cells.
void keep_near(std::span<const MwghtVote> votes, int x, int y, int size, int reach,
               std::vector<MwghtVote>& near) {
  near.resize(votes.size() + 1);
  const auto span = static_cast<unsigned>(size - 1 + 2 * reach);
  std::size_t count = 0;
  for (const MwghtVote& vote : votes) {
    near[count] = vote;
    count += static_cast<std::size_t>(static_cast<unsigned>(vote.x - x + reach) <= span) &
             static_cast<std::size_t>(static_cast<unsigned>(vote.y - y + reach) <= span);
  }
  near.resize(count);
}

/// Bounds of 4 x 4 boxes; column = y.
Bounds4x4 bounds_of_boxes(std::span<const MwghtVote> near, int x, int y, const MwghtBounds& table,
                          double share) {
  Eigen::Array4f row0 = Eigen::Array4f::Zero(), row1 = row0, row2 = row0, row3 = row0;
  for (const MwghtVote& vote : near) {
    const auto weight = static_cast<float>(vote.weight * share);
    const int dx = x - vote.x, dy = y - vote.y;
    row0 += weight * table.four(dx, dy, 0, 0);
    row1 += weight * table.four(dx, dy, 0, 1);
    row2 += weight * table.four(dx, dy, 0, 2);
    row3 += weight * table.four(dx, dy, 0, 3);
  }
  Bounds4x4 bounds;
  bounds << row0, row1, row2, row3;
  return bounds;
}

/// Calls visit(i, j) for the boxes that may hold something greater, the most promising first. The threshold
/// may rise meanwhile.
template <class Visit>
void visit_by_promise(Bounds4x4 bounds, const float& threshold, Visit visit) {
  for (;;) {
    int i = 0, j = 0;
    if (bounds.maxCoeff(&i, &j) < threshold) return;
    bounds(i, j) = -1;
    visit(i, j);
  }
}

}  // namespace

MwghtSearch::MwghtSearch(const MwghtParams&, const MwghtKernel& kernel)
    : kernel_(kernel),
      coarse_(kernel, kCoarse, -kernel.reach() - kCoarse + 1, kCoarse, squares_reached(kernel.reach())),
      fine_(kernel, kFine, -kernel.reach() - kCoarse + 1, 2 * kernel.reach() + kCoarse, kCoarse / kFine),
      cell_(kernel, 1, -kernel.reach() - kFine + 1, 2 * kernel.reach() + kFine, kFine) {}

void MwghtSearch::bound_squares(const MwghtVotes& votes, const MwghtGrid& grid) {
  votes_ = &votes;
  grid_ = grid;
  share_ = votes.weight_max() > 0 ? 1 / votes.weight_max() : 1;
  slack_ = 1 + static_cast<double>(votes.count_max() + 16) * kFloatStep;
  squares_.clear();
  for (int turn = 0; turn < grid.turns(); ++turn) bound_squares_of(turn);
}

/// The same voting, coarsely: each vote gives each square the most that it can give any of its cells.
void MwghtSearch::bound_squares_of(int turn) {
  const int reach = kernel_.reach();
  const int margin = (2 * reach + kCoarse - 1) / kCoarse;
  const int columns = (grid_.columns() - 1) / kCoarse + 1, rows = (grid_.rows() - 1) / kCoarse + 1;
  stride_ = columns + margin + margin + coarse_.boxes();
  sums_.assign(static_cast<std::size_t>(stride_ * (rows + margin + margin + coarse_.boxes())), 0.0F);
  for (const MwghtVote& vote : votes_->of_turn(turn)) {
    const auto weight = static_cast<float>(vote.weight * share_);
    const int x = (vote.x - reach) >> 4, y = (vote.y - reach) >> 4;
    float* sums = &sums_[static_cast<std::size_t>((y + margin) * stride_ + x + margin)];
    for (int j = 0; j < squares_reached(reach); ++j, sums += stride_) {
      for (int i = 0; i < coarse_.boxes(); i += 4) {
        Eigen::Array4f::Map(sums + i) +=
            weight * coarse_.four(x * kCoarse - vote.x, y * kCoarse - vote.y, i, j);
      }
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const float bound = sums_[static_cast<std::size_t>((y + margin) * stride_ + x + margin)];
      squares_.push_back({bound, turn, y * kCoarse, x * kCoarse});
    }
  }
}

std::optional<MwghtMaximum> MwghtSearch::maximum(const MwghtVicinity* excluded) {
  excluded_ = excluded;
  best_.reset();
  threshold_ = 0;
  const auto by_bound = [](const Square& a, const Square& b) { return a.bound > b.bound; };

  const Square* promising = nullptr;
  for (const Square& square : squares_) {
    if ((!promising || square.bound > promising->bound) && !is_excluded(square, kCoarse)) promising = &square;
  }
  if (!promising) return std::nullopt;
  divide(*promising);

  queue_.clear();
  for (const Square& square : squares_) {
    if (square.bound >= threshold_ && &square != promising && !is_excluded(square, kCoarse))
      queue_.push_back(square);
  }
  std::sort(queue_.begin(), queue_.end(), by_bound);
  for (const Square& square : queue_) {
    if (square.bound < threshold_) break;
    divide(square);
  }
  return best_;
}

void MwghtSearch::divide(const Square& square) {
  keep_near(votes_->of_turn(square.turn), square.x, square.y, kCoarse, kernel_.reach(), near_coarse_);
  if (near_coarse_.empty()) return;
  visit_by_promise(bounds_of_boxes(near_coarse_, square.x, square.y, fine_, share_), threshold_,
                   [&](int i, int j) {
                     divide_fine({0, square.turn, square.y + kFine * j, square.x + kFine * i});
                   });
}

void MwghtSearch::divide_fine(const Square& square) {
  if (square.x >= grid_.columns() || square.y >= grid_.rows() || is_excluded(square, kFine)) return;
  keep_near(near_coarse_, square.x, square.y, kFine, kernel_.reach(), near_fine_);
  if (near_fine_.empty()) return;
  visit_by_promise(bounds_of_boxes(near_fine_, square.x, square.y, cell_, share_), threshold_,
                   [&](int i, int j) { try_cell(square.turn, square.y + j, square.x + i); });
}

void MwghtSearch::try_cell(int turn, int y, int x) {
  if (x >= grid_.columns() || y >= grid_.rows()) return;
  const MwghtCell cell = grid_.cell(turn, y, x);
  if (excluded_ && excluded_->holds(cell)) return;
  double value = 0;
  for (const MwghtVote& vote : near_fine_) value += vote.weight * kernel_(x - vote.x, y - vote.y);
  const MwghtMaximum maximum{cell, value};
  if (value > 0 && (!best_ || maximum.beats(*best_))) take_as_best(maximum);
}

void MwghtSearch::take_as_best(const MwghtMaximum& maximum) {
  best_ = maximum;
  const double scaled = maximum.value * share_;
  threshold_ = scaled > kFloatFloor ? static_cast<float>(scaled / slack_) : 0;
}

bool MwghtSearch::is_excluded(const Square& square, int size) const {
  return excluded_ && excluded_->holds_square(grid_.cell(square.turn, square.y, square.x), size);
}

}  // namespace aisle
