#pragma once
/// Branch and bound over the cells: squares of 16 x 16 cells of one angle are divided into squares of 4 x 4
/// and these into cells. A square that cannot hold a greater cell than the best so far is not divided.

#include <array>

#include "mwght_kernel.hpp"
#include "mwght_maximum.hpp"

namespace aisle {

class MwghtSearch {
 public:
  MwghtSearch(const MwghtParams& params, const MwghtKernel& kernel);

  /// Bounds every square of the window; `votes` must live as long as maxima are asked for.
  void bound_squares(const MwghtVotes& votes, const MwghtGrid& grid);

  /// The greatest cell that is not in `excluded`; nullopt: no votes there.
  std::optional<MwghtMaximum> maximum(const MwghtVicinity* excluded = nullptr);

 private:
  struct Square {
    float bound = 0;
    int turn = 0, y = 0, x = 0;  ///< of its least cell, counted like the grid's
  };

  void bound_squares_of(int turn);
  void divide(const Square& square);
  void divide_fine(const Square& square);
  void try_cell(int turn, int y, int x);
  void take_as_best(const MwghtMaximum& maximum);
  bool is_excluded(const Square& square, int size) const;

  const MwghtKernel& kernel_;
  MwghtBounds coarse_, fine_, cell_;
  const MwghtVotes* votes_ = nullptr;
  MwghtGrid grid_;
  int stride_ = 0;           ///< of sums_
  std::vector<float> sums_;  ///< of one angle: bounds by square, with a margin around the window
  std::vector<Square> squares_;
  std::vector<Square> queue_;
  std::vector<MwghtVote> near_coarse_, near_fine_;  ///< votes that reach into the square

  const MwghtVicinity* excluded_ = nullptr;
  std::optional<MwghtMaximum> best_;
  float threshold_ = 0;  ///< squares with a bound below this hold nothing greater than the best
  double share_ = 1;     ///< bounds are of weights times this
  double slack_ = 1;     ///< factor by which rounding may have lowered a bound
};

}  // namespace aisle
