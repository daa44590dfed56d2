#pragma once

#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Columns and distances are shares of the picture's width.
struct LineFollowerParams {
  double gate = 0.035;        ///< from where a line was expected
  double turn_max = 0.3;      ///< how far the corridor's end may be from the middle
  double approach_max = 8;    ///< between two pictures: what is at distance x from the corridor's end goes
                              ///< to x / (1 - approach x), as points of a side wall do
  double slope_gate = 0.15;   ///< change of a line's slope
  double tone_gate = 45;      ///< change of the grey level on either side
  double likeness_min = 1.5;  ///< of all lines together, 1 for each at best and less for great motion:
                              ///< below it none was followed

  void describe(FieldList& fields);
};

/// Follows vertical lines through the pictures of one drive along a corridor, which may be metres apart: of
/// all turns and approaches the one under which most lines find their like (by column, slope, polarity and
/// the tones on both sides), in the same order from left to right.
class LineFollower {
 public:
  explicit LineFollower(const LineFollowerParams& params = {}) : params_(params) {}

  /// @param lines  of this picture, from left to right
  /// @return for each the number of the same line in the picture before, or one never given yet, from 0
  std::vector<int> follow(const Image& grey, const std::vector<VerticalLine>& lines);

  /// A line as it is recognised.
  struct Look {
    double column = 0;  ///< half-way down the picture; 0 is the middle of the width
    double slope = 0;   ///< columns to the right for each row down
    double tone_left = 0;
    double tone_right = 0;

    bool brighter_right() const { return tone_right > tone_left; }
  };

 private:
  LineFollowerParams params_;
  std::vector<Look> looks_;  // of the picture before
  std::vector<int> numbers_;
  int next_number_ = 0;
};

}  // namespace aisle
