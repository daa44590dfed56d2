#pragma once

#include <array>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"

namespace aisle {

inline constexpr int kViewColumns = 128, kViewBands = 4;

/// How bright an image's columns are in four bands of its rows, the upper first: `kViewColumns` x
/// `kViewBands` pixels, grey. The published views (`brightness_view.hpp`) keep only where such curves are
/// highest and lowest.
/// @param image  not empty
Image column_view(const Image& image);

/// How much two views of one place may differ. Columns are shares of the image's width.
struct ColumnViewParams {
  double lateral_max = 0.08;
  double approach_max = 0;

  void describe(FieldList& fields);
};

/// The curves of a view, ready to be compared with others': as seen from its place, and as the side walls
/// would look from places ahead of it.
class ViewCurves {
 public:
  /// @param view  of `column_view`
  ViewCurves(const ColumnViewParams& params, const Image& view);

  /// One minus the correlation with another view's curves where they agree best, whichever of the two is
  /// ahead: 0 the same but for the light, 1 nothing in common, at most 2. O(approaches x shifts x columns).
  double unlikeness(const ViewCurves& other) const;

 private:
  using Columns = std::array<float, kViewColumns>;
  using Sums = std::array<double, kViewColumns + 1>;

  /// The curves for one approach.
  struct Curves {
    std::array<Columns, kViewBands> tone{};  ///< logarithms: light is a factor; about their mean
    std::array<Sums, kViewBands> sum{};      ///< of the tones of all columns before
    std::array<Sums, kViewBands> squares{};  ///< of their squares
  };

  void add_approached(const std::array<Columns, kViewBands>& tones, double end, double approach);
  static double correlation(const Curves& a, const Curves& b, int lateral);
  double best_correlation(const Curves& curves, const Curves& seen) const;

  std::vector<Curves> approached_;  ///< the first from its place
  int lateral_max_;                 ///< columns
};

}  // namespace aisle
