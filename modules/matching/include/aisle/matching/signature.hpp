#pragma once
/// Signatures of orthogonal line-segment patterns and their correlation: C99 Algorithm 2.

#include <optional>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// One marked symbol on an axis.
struct SignatureSymbol {
  int kind = 0;  ///< only symbols of the same kind are compared
  double position_m = 0;
  double weight = 0;
};

/// The symbols of a pattern on one axis.
using Signature = std::vector<SignatureSymbol>;

/// A segment with the weights of the symbols that it marks (step 2): its own coordinate and its two end
/// points.
struct MarkedSegment {
  Segment2 segment;
  double length_weight = 0;  ///< the length, or a capped length
  double start_weight = 0;   ///< c; 0: not marked
  double end_weight = 0;
};

/// Whether symbols of walls that face opposite directions, and the two ends of a wall, support each other.
enum class SymbolKinds {
  kOne,       ///< they do, as published
  kByFacing,  ///< they do not
};

/// Marks a segment on an axis (unit vector): a segment perpendicular to the axis marks its coordinate, a
/// parallel one its end points. As published, the axes are x and y; in a building with other angles they are
/// any two directions.
void mark(const MarkedSegment& marked, const Vec2& axis, SymbolKinds kinds, Signature& signature);

struct SignatureParams {
  double reach_m = 0.4;    ///< displacements up to this are tried
  double cell_m = 0.02;    ///< cells of the signature space
  int neighbourhood = 10;  ///< k of step 4 [cells]
  double tolerance = 3;    ///< d of step 4 [cells]
};

/// Correlation of two signatures over all displacements in -reach .. reach: C(x_d) of step 5 with step 4's
/// fuzzy tolerance, whose weight is 1 / (1 + |i| / d) (the printed formula lacks the bars).
///
/// Each pair of symbols adds the kernel's autocorrelation at its displacement, which equals correlating the
/// blurred signatures cell by cell but costs O(symbols within reach), whatever the size of the building.
class SignatureCorrelator {
 public:
  explicit SignatureCorrelator(const SignatureParams& params);

  /// Values for displacements that move `sensed` onto `learned`; index 0 is -reach. Valid until the next
  /// call. `learned` must be sorted by kind, then position (sort_symbols).
  std::span<double> correlate(std::span<const SignatureSymbol> sensed,
                              std::span<const SignatureSymbol> learned);

  double displacement_m(std::size_t index) const;

  /// The displacement of the highest value, refined to sub-cell accuracy by a parabola; in a tie the first
  /// index wins. nullopt if nothing correlates.
  std::optional<double> peak_m() const;

  /// Displacements of the `count` highest peaks, each at least `apart_m` from the others; destroys the
  /// values.
  void peaks_m(int count, double apart_m, std::vector<double>& peaks);

 private:
  std::optional<std::size_t> highest() const;
  double refined_m(std::size_t index) const;

  SignatureParams params_;
  int half_cells_;
  std::vector<double> kernel_;  ///< autocorrelation of the tolerance weights
  std::vector<double> values_;
};

/// Sorts a learned signature as correlating needs it.
void sort_symbols(Signature& signature);

}  // namespace aisle
