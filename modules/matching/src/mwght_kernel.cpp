#include "mwght_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kReachRounding = 1e-9;  // a reach of whole cells includes the last one

/// The offset, along one axis, of the cell of a box that is nearest to the vote.
int nearest_offset(int first, int box) {
  return std::clamp(0, first, first + box - 1);
}

}  // namespace

MwghtKernel::MwghtKernel(const MwghtParams& params)
    : reach_(static_cast<int>(std::floor(params.reach_m / params.cell_m + kReachRounding))) {
  values_.reserve(static_cast<std::size_t>((2 * reach_ + 1) * (2 * reach_ + 1)));
  for (int dy = -reach_; dy <= reach_; ++dy) {
    for (int dx = -reach_; dx <= reach_; ++dx) {
      const double d1_m = params.cell_m * std::sqrt(dx * dx + dy * dy);  // eq. (7)
      const bool within = d1_m <= params.reach_m + kReachRounding * params.cell_m;
      values_.push_back(within ? 1 / (1 + d1_m / params.distance_scale_m) : 0);  // eq. (6)
    }
  }
}

template <int kBox>
MwghtBounds<kBox>::MwghtBounds(const MwghtKernel& kernel, int first_offset, int offsets, int boxes)
    : first_offset_(first_offset), steps_(static_cast<unsigned>((offsets - 1) / kBox + boxes)) {
  const int steps = static_cast<int>(steps_);
  for (int phase = 0; phase < kBox * kBox; ++phase) {
    for (int step = 0; step < steps * steps; ++step) {
      const int x = first_offset + step % steps * kBox + phase % kBox;
      const int y = first_offset + step / steps * kBox + phase / kBox;
      values_.push_back(static_cast<float>(kernel(nearest_offset(x, kBox), nearest_offset(y, kBox))));
    }
  }
}

template class MwghtBounds<1>;
template class MwghtBounds<4>;
template class MwghtBounds<16>;

}  // namespace aisle
