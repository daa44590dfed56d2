#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "aisle/core/image.hpp"

namespace aisle {

/// Where the brightness steps across a column.
struct EdgePoint {
  float u_px = 0;
  float v_px = 0;
  float contrast = 0;  ///< size of the step [grey levels]; > 0
};

/// Which way the brightness steps from left to right.
enum class Step : std::uint8_t { kBrighter, kDarker };
constexpr std::array<Step, 2> kBothSteps{Step::kBrighter, Step::kDarker};

/// The steps across the columns in one band of rows, found in the sums of its rows.
class EdgeBand {
 public:
  /// The image must be at least 7 pixels wide, `rows` at most 64.
  void find(const Image& grey, int first_row, int rows, float contrast_min);

  const std::vector<EdgePoint>& edges(Step step) const { return edges_[static_cast<std::size_t>(step)]; }
  int columns() const { return static_cast<int>(sums_.size()); }
  /// Index of the edge that is nearest to this column's centre, -1 if none.
  int edge_at(Step step, int column) const {
    return edge_at_[static_cast<std::size_t>(step)][static_cast<std::size_t>(column)];
  }

 private:
  void forget();
  void sum_rows(const Image& grey, int first_row, int rows);
  void differentiate();
  void add(Step step, const EdgePoint& edge);

  std::vector<std::int16_t> sums_;
  std::vector<std::int16_t> slopes_;
  std::array<std::vector<EdgePoint>, 2> edges_;
  std::array<std::vector<int>, 2> edge_at_;
};

}  // namespace aisle
