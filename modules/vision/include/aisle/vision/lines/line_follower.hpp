#pragma once

#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Columns and distances are shares of the image's width.
struct LineFollowerParams {
  double gate = 0.035;        ///< how far from its expected column a line may be
  double turn_max = 0.3;      ///< how far the corridor's end may be from the middle
  double approach_max = 8;    ///< between two images: what is at distance x from the corridor's end goes
                              ///< to x / (1 - approach x), as points of a side wall do
  double slope_gate = 0.15;   ///< change of a line's slope
  double tone_gate = 45;      ///< change of the grey level on either side
  double likeness_min = 1.5;  ///< of all lines together, at best 1 for each and less for large motion:
                              ///< below it none was followed

  void describe(FieldList& fields);
};

/// A line as it is recognised.
struct LineLook {
  double column = 0;  ///< at half the image's height; 0 is the middle of the width
  double slope = 0;   ///< columns to the right for each row down
  double tone_left = 0;
  double tone_right = 0;

  bool brighter_right() const { return tone_right > tone_left; }
};

/// @param lines  of this image, from left to right
std::vector<LineLook> line_looks(const Image& grey, const std::vector<VerticalLine>& lines);

/// How alike the lines of two images are under the camera motion that makes them most alike, whichever of
/// the two is ahead: 1 for the same lines, less where lines of either have no match in the other, at least 0.
/// Two images without lines are alike. O(motions x lines of each).
double lines_likeness(const std::vector<LineLook>& a, const std::vector<LineLook>& b,
                      const LineFollowerParams& params);

/// Follows vertical lines through the images of one drive along a corridor, which may be metres apart. It
/// takes the turn and approach under which most lines match (by column, slope, polarity and the tones on both
/// sides), in the same order from left to right.
class LineFollower {
 public:
  explicit LineFollower(const LineFollowerParams& params = {}) : params_(params) {}

  /// @param lines  of this image, from left to right
  /// @return for each line, the number of the same line in the previous image, or a new number; from 0
  std::vector<int> follow(const Image& grey, const std::vector<VerticalLine>& lines);

 private:
  LineFollowerParams params_;
  std::vector<LineLook> looks_;  // of the image before
  std::vector<int> numbers_;
  int next_number_ = 0;
};

}  // namespace aisle
