#pragma once
/// Branch and bound over the cells: squares of 16 x 16 cells of one angle are divided into squares of 4 x 4
/// and these into cells. A square that cannot hold a greater cell than the best so far is not divided.

#include "mwght_kernel.hpp"
#include "mwght_maximum.hpp"

namespace aisle {

class MwghtSearch {
 public:
  explicit MwghtSearch(const MwghtKernel& kernel);

  /// Bounds every square of the window; `votes` must live as long as maxima are asked for.
  void bound_squares(const MwghtVotes& votes, const MwghtGrid& grid);

  /// The cell with the greatest value outside `excluded`; nullopt: no votes there.
  std::optional<MwghtMaximum> maximum(const MwghtVicinity* excluded = nullptr);

 private:
  struct Square {
    float bound = 0;
    int turn = 0, y = 0, x = 0;  ///< of its least cell, counted like the grid's
  };

  void bound_squares_of(int turn);
  template <int kSide>
  void divide(const Square& square, std::span<const MwghtVote> votes);
  template <int kSide>
  const auto& bounds_of_parts() const;
  void try_cell(const Square& square, std::span<const MwghtVote> votes);
  void take_as_best(const MwghtMaximum& maximum);
  bool is_excluded(const Square& square, int size) const;

  const MwghtKernel& kernel_;
  int reached_;  ///< squares along an axis that one vote may reach
  MwghtBounds<16> bounds_16_;
  MwghtBounds<4> bounds_4_;
  MwghtBounds<1> bounds_1_;
  const MwghtVotes* votes_ = nullptr;
  MwghtGrid grid_;
  int stride_ = 0;           ///< of sums_
  std::vector<float> sums_;  ///< of one angle: bounds by square, with a margin around the window
  std::vector<Square> squares_;
  std::vector<Square> queue_;
  std::vector<MwghtVote> near_16_, near_4_;  ///< votes that reach into the square of this side

  const MwghtVicinity* excluded_ = nullptr;
  std::optional<MwghtMaximum> best_;
  float threshold_ = 0;  ///< squares with a bound below this hold nothing greater than the best
  double share_ = 1;     ///< bounds are of weights times this
  double slack_ = 1;     ///< factor by which rounding may have lowered a bound
};

}  // namespace aisle
