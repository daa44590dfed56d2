#pragma once
/// The cell that each pair of points votes for, angle by angle.

#include <span>
#include <vector>

#include "aisle/matching/mwght.hpp"

namespace aisle {

/// The cells of a window, counted from its least corner.
struct MwghtGrid {
  int half_x = 0, half_y = 0, half_turn = 0;

  MwghtGrid() = default;
  MwghtGrid(const MwghtParams& params, const MwghtWindow& window);

  int columns() const { return 2 * half_x + 1; }
  int rows() const { return 2 * half_y + 1; }
  int turns() const { return 2 * half_turn + 1; }
  MwghtCell cell(int turn, int y, int x) const { return {x - half_x, y - half_y, turn - half_turn}; }
};

/// The displacement of one pair at one angle: the nearest cell, counted like the grid's, possibly outside of
/// it.
struct MwghtVote {
  int x = 0, y = 0;
  double weight = 0;  ///< W_P W_Q
};

/// The votes that reach into the window. Those of one angle are in the order of the pairs, seen points first;
/// every sum is added in this order.
class MwghtVotes {
 public:
  explicit MwghtVotes(const MwghtParams& params) : params_(params) {}

  /// @param reach  of a vote [cells]
  void gather(std::span<const WeightedPoint> learned, std::span<const WeightedPoint> seen,
              const MwghtGrid& grid, int reach);

  std::span<const MwghtVote> of_turn(int turn) const {
    const auto begin = static_cast<std::size_t>(turn);
    return std::span(votes_).subspan(first_[begin], first_[begin + 1] - first_[begin]);
  }
  double weight_max() const { return weight_max_; }
  std::size_t count_max() const { return count_max_; }  ///< of one angle

 private:
  struct Pair {
    Vec2 p_learned, p_seen;
    double weight;
  };
  struct Turn {
    double cosine, sine;
  };

  void pair_within_reach(std::span<const WeightedPoint> learned, std::span<const WeightedPoint> seen,
                         const MwghtGrid& grid, int reach);

  MwghtParams params_;
  std::vector<Pair> pairs_;
  std::vector<MwghtVote> votes_;
  std::vector<std::size_t> first_;
  double weight_max_ = 0;
  std::size_t count_max_ = 0;
};

}  // namespace aisle
