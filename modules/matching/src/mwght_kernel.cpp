#include "mwght_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kRounding = 1e-9;  // a reach of whole cells includes the last one

int round_up_to_fours(int n) {
  return (n + 3) / 4 * 4;
}

/// Of a box's cells along one axis, the offset of the one nearest to the vote.
int nearest_offset(int first, int box) {
  return std::clamp(0, first, first + box - 1);
}

}  // namespace

MwghtKernel::MwghtKernel(const MwghtParams& params)
    : reach_(static_cast<int>(std::floor(params.reach_m / params.cell_m + kRounding))) {
  values_.reserve(static_cast<std::size_t>((2 * reach_ + 1) * (2 * reach_ + 1)));
  for (int dy = -reach_; dy <= reach_; ++dy) {
    for (int dx = -reach_; dx <= reach_; ++dx) {
      const double d1_m = params.cell_m * std::sqrt(dx * dx + dy * dy);  // eq. (7)
      const bool within = d1_m <= params.reach_m + kRounding * params.cell_m;
      values_.push_back(within ? 1 / (1 + d1_m / params.distance_scale_m) : 0);  // eq. (6)
    }
  }
}

MwghtBounds::MwghtBounds(const MwghtKernel& kernel, int box, int first_offset, int offsets, int boxes)
    : box_(box),
      first_offset_(first_offset),
      boxes_(round_up_to_fours(boxes)),
      quotients_((offsets - 1) / box + boxes_) {
  const int rows = offsets + (boxes_ - 1) * box;
  for (int y = 0; y < rows; ++y) {
    for (int phase = 0; phase < box; ++phase) {
      for (int quotient = 0; quotient < quotients_; ++quotient) {
        const int x = quotient * box + phase;
        values_.push_back(static_cast<float>(
            kernel(nearest_offset(first_offset + x, box), nearest_offset(first_offset + y, box))));
      }
    }
  }
}

}  // namespace aisle
