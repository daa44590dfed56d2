#pragma once
/// The published method: every vote into every cell of a three-dimensional array.

#include "mwght_kernel.hpp"
#include "mwght_maximum.hpp"

namespace aisle {

class MwghtArray {
 public:
  void vote(const MwghtVotes& votes, const MwghtGrid& grid, const MwghtKernel& kernel);

  /// The cell with the greatest value outside `excluded`; nullopt: no votes there.
  std::optional<MwghtMaximum> maximum(const MwghtVicinity* excluded = nullptr) const;

 private:
  double* row(int turn, int y) {
    return &values_[(static_cast<std::size_t>(turn) * static_cast<std::size_t>(grid_.rows()) +
                     static_cast<std::size_t>(y)) *
                    static_cast<std::size_t>(grid_.columns())];
  }

  MwghtGrid grid_;
  std::vector<double> values_;  ///< H by (turn, y, x)
};

}  // namespace aisle
