#include "mwght_search.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr int kTop = 16;  // side of the largest squares [cells]
constexpr double kFloatStep = 1.0 / (1 << 22);
constexpr double kFloatFloor = 1e-30;  // sums of shares below this may have lost products to underflow

/// The votes, in their order, that reach into the square of `side` cells from (x, y) on; stored in `buffer`.
std::span<const MwghtVote> near(std::span<const MwghtVote> votes, int x, int y, int side, int reach,
                                std::vector<MwghtVote>& buffer) {
  if (buffer.size() <= votes.size()) buffer.resize(votes.size() + 1);
  const auto span = static_cast<unsigned>(side - 1 + 2 * reach);
  MwghtVote* end = buffer.data();
  for (const MwghtVote& vote : votes) {
    *end = vote;
    const bool in_x = static_cast<unsigned>(vote.x - x + reach) <= span;
    const bool in_y = static_cast<unsigned>(vote.y - y + reach) <= span;
    end += static_cast<int>(in_x) & static_cast<int>(in_y);
  }
  return {buffer.data(), end};
}

/// Upper bounds of what the votes add to each of 4 x 4 boxes from (x, y) on: element (i, j) for column i and
/// row j.
template <int kBox>
Eigen::Array44f sum_bounds(std::span<const MwghtVote> votes, int x, int y, const MwghtBounds<kBox>& bounds,
                           double share) {
  const std::size_t steps = bounds.steps();
  Eigen::Array4f row0 = Eigen::Array4f::Zero(), row1 = row0, row2 = row0, row3 = row0;
  for (const MwghtVote& vote : votes) {
    const auto weight = static_cast<float>(vote.weight * share);
    const float* const first = bounds.first(x - vote.x, y - vote.y);
    row0 += weight * Eigen::Array4f::Map(first);
    row1 += weight * Eigen::Array4f::Map(first + steps);
    row2 += weight * Eigen::Array4f::Map(first + 2 * steps);
    row3 += weight * Eigen::Array4f::Map(first + 3 * steps);
  }
  Eigen::Array44f sums;
  sums << row0, row1, row2, row3;
  return sums;
}

}  // namespace

MwghtSearch::MwghtSearch(const MwghtKernel& kernel)
    : kernel_(kernel),
      reached_((2 * kernel.reach() + kTop - 1) / kTop + 1),
      bounds_16_(kernel, -kernel.reach() - 15, 16, (reached_ + 3) / 4 * 4),
      bounds_4_(kernel, -kernel.reach() - 15, 2 * kernel.reach() + 16),
      bounds_1_(kernel, -kernel.reach() - 3, 2 * kernel.reach() + 4) {}

void MwghtSearch::bound_squares(const MwghtVotes& votes, const MwghtGrid& grid) {
  votes_ = &votes;
  grid_ = grid;
  share_ = votes.weight_max() > 0 ? 1 / votes.weight_max() : 1;
  slack_ = 1 + static_cast<double>(votes.count_max() + 16) * kFloatStep;
  squares_.clear();
  for (int turn = 0; turn < grid.turns(); ++turn) bound_squares_of(turn);
}

/// Coarse voting: each vote gives each square the most that it can give any of its cells.
void MwghtSearch::bound_squares_of(int turn) {
  const int reach = kernel_.reach();
  const int reached = reached_, margin = reached - 1;
  const std::size_t steps = bounds_16_.steps();
  const int columns = (grid_.columns() - 1) / kTop + 1, rows = (grid_.rows() - 1) / kTop + 1;
  const int stride = columns + 2 * margin + 4;
  sums_.assign(static_cast<std::size_t>(stride * (rows + 2 * margin + 1)), 0.0F);
  for (const MwghtVote& vote : votes_->of_turn(turn)) {
    const auto weight = static_cast<float>(vote.weight * share_);
    const int x = (vote.x - reach) >> 4, y = (vote.y - reach) >> 4;
    const float* bounds = bounds_16_.first(x * kTop - vote.x, y * kTop - vote.y);
    float* sums = &sums_[static_cast<std::size_t>((y + margin) * stride + x + margin)];
    for (int j = 0; j < reached; ++j, sums += stride, bounds += steps) {
      for (int i = 0; i < reached; i += 4)
        Eigen::Array4f::Map(sums + i) += weight * Eigen::Array4f::Map(bounds + i);
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const float bound = sums_[static_cast<std::size_t>((y + margin) * stride + x + margin)];
      squares_.push_back({bound, turn, y * kTop, x * kTop});
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
    if ((!promising || square.bound > promising->bound) && !is_excluded(square, kTop)) promising = &square;
  }
  if (!promising) return std::nullopt;
  divide<kTop>(*promising, votes_->of_turn(promising->turn));

  queue_.clear();
  for (const Square& square : squares_) {
    if (square.bound >= threshold_ && &square != promising) queue_.push_back(square);
  }
  std::sort(queue_.begin(), queue_.end(), by_bound);
  for (const Square& square : queue_) {
    if (square.bound < threshold_) break;
    divide<kTop>(square, votes_->of_turn(square.turn));
  }
  return best_;
}

template <int kSide>
const auto& MwghtSearch::bounds_of_parts() const {
  if constexpr (kSide == 16) return bounds_4_;
  if constexpr (kSide == 4) return bounds_1_;
}

template <int kSide>
void MwghtSearch::divide(const Square& square, std::span<const MwghtVote> votes) {
  if (square.x >= grid_.columns() || square.y >= grid_.rows() || is_excluded(square, kSide)) return;
  if constexpr (kSide == 1) {
    try_cell(square, votes);
  } else {
    const auto reaching =
        near(votes, square.x, square.y, kSide, kernel_.reach(), kSide == 16 ? near_16_ : near_4_);
    if (reaching.empty()) return;
    constexpr int kPart = kSide / 4;
    Eigen::Array44f bounds = sum_bounds(reaching, square.x, square.y, bounds_of_parts<kSide>(), share_);
    for (;;) {
      int i = 0, j = 0;
      const float bound = bounds.maxCoeff(&i, &j);
      if (bound < threshold_) return;
      bounds(i, j) = -1;
      divide<kPart>({bound, square.turn, square.y + j * kPart, square.x + i * kPart}, reaching);
    }
  }
}

void MwghtSearch::try_cell(const Square& square, std::span<const MwghtVote> votes) {
  double value = 0;
  for (const MwghtVote& vote : votes) value += vote.weight * kernel_(square.x - vote.x, square.y - vote.y);
  const MwghtMaximum maximum{grid_.cell(square.turn, square.y, square.x), value};
  if (value > 0 && (!best_ || maximum.beats(*best_))) take_as_best(maximum);
}

void MwghtSearch::take_as_best(const MwghtMaximum& maximum) {
  best_ = maximum;
  const double scaled = maximum.value * share_;
  threshold_ = scaled > kFloatFloor ? static_cast<float>(scaled / slack_) : 0;
}

bool MwghtSearch::is_excluded(const Square& square, int side) const {
  return excluded_ && excluded_->holds_square(grid_.cell(square.turn, square.y, square.x), side);
}

}  // namespace aisle
