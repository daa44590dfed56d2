#include "aisle/vision/places/column_view.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace aisle {
namespace {

using Tones = Eigen::Map<const Eigen::VectorXf>;

constexpr double kDarkest = 10;   ///< lower grey levels tell nothing
constexpr double kNoise = 0.005;  ///< of tones, so that curves without contrast are not alike
constexpr int kEnds = 3;          ///< positions of the corridor's end that are tried to either side ...
constexpr double kEndStep = 0.05;
constexpr int kApproaches = 6;

}  // namespace

Image column_view(const Image& image) {
  return shrunk(to_grey(image), kViewColumns, kViewBands);
}

void ColumnViewParams::describe(FieldList& fields) {
  fields.real("lateral_max", lateral_max, {0, 0.4},
              "by which a view may be shifted to either side, share of its width");
  fields.real("approach_max", approach_max, {0, 100},
              "forward motion between two views: x, from the corridor's end, goes to x / (1 - it x)");
}

ViewCurves::ViewCurves(const ColumnViewParams& params, const Image& view)
    : lateral_max_(static_cast<int>(std::lround(params.lateral_max * kViewColumns))) {
  std::array<Columns, kViewBands> tones;
  for (int band = 0; band < kViewBands; ++band) {
    Columns& tone = tones[static_cast<std::size_t>(band)];
    std::transform(view.row(band), view.row(band) + kViewColumns, tone.begin(),
                   [](std::uint8_t grey) { return static_cast<float>(std::log(grey + kDarkest)); });
    const float mean = std::accumulate(tone.begin(), tone.end(), 0.0F) / kViewColumns;
    for (float& value : tone) value -= mean;
  }
  add_approached(tones, 0, 0);
  if (params.approach_max == 0) return;
  for (int i = 1; i <= kApproaches; ++i) {
    const double share = static_cast<double>(i) / kApproaches;
    for (int end = -kEnds; end <= kEnds; ++end)
      add_approached(tones, kEndStep * end, params.approach_max * share * share);
  }
}

/// @param end  column of the corridor's end, from the middle
void ViewCurves::add_approached(const std::array<Columns, kViewBands>& tones, double end, double approach) {
  Curves& curves = approached_.emplace_back();
  for (std::size_t column = 0; column < kViewColumns; ++column) {
    const double from_end = (static_cast<double>(column) + 0.5) / kViewColumns - 0.5 - end;
    const double before = end + from_end / (1 + approach * std::abs(from_end));
    const double at = std::clamp((before + 0.5) * kViewColumns - 0.5, 0.0, kViewColumns - 1.0);
    const auto left = std::min(static_cast<std::size_t>(at), std::size_t{kViewColumns - 2});
    for (std::size_t band = 0; band < kViewBands; ++band) {
      const Columns& tone = tones[band];
      const double value = std::lerp(tone[left], tone[left + 1], at - static_cast<double>(left));
      curves.tone[band][column] = static_cast<float>(value);
      curves.sum[band][column + 1] = curves.sum[band][column] + value;
      curves.squares[band][column + 1] = curves.squares[band][column] + value * value;
    }
  }
}

/// Correlation of the columns that both have if `b` is shifted by `lateral` to the left.
double ViewCurves::correlation(const Curves& a, const Curves& b, int lateral) {
  const int from = std::max(0, -lateral), to = std::min(kViewColumns, kViewColumns - lateral);
  const double columns = to - from;
  const auto within = [&](const Sums& sums, int shift) {
    return sums[static_cast<std::size_t>(to + shift)] - sums[static_cast<std::size_t>(from + shift)];
  };
  double both = 0, of_a = 0, of_b = 0;
  for (std::size_t band = 0; band < kViewBands; ++band) {
    const double product = Tones(a.tone[band].data() + from, to - from)
                               .dot(Tones(b.tone[band].data() + from + lateral, to - from));
    const double sum_a = within(a.sum[band], 0), sum_b = within(b.sum[band], lateral);
    both += product - sum_a * sum_b / columns;
    of_a += within(a.squares[band], 0) - sum_a * sum_a / columns;
    of_b += within(b.squares[band], lateral) - sum_b * sum_b / columns;
  }
  const double noise = kViewBands * columns * kNoise * kNoise;
  return both / std::sqrt((of_a + noise) * (of_b + noise));
}

double ViewCurves::best_correlation(const Curves& curves, const Curves& seen) const {
  double best = -1;
  for (int lateral = -lateral_max_; lateral <= lateral_max_; ++lateral)
    best = std::max(best, correlation(curves, seen, lateral));
  return best;
}

double ViewCurves::unlikeness(const ViewCurves& other) const {
  double best = best_correlation(approached_.front(), other.approached_.front());
  for (std::size_t i = 1; i < approached_.size(); ++i)
    best = std::max(best, best_correlation(approached_[i], other.approached_.front()));
  for (std::size_t i = 1; i < other.approached_.size(); ++i)
    best = std::max(best, best_correlation(other.approached_[i], approached_.front()));
  return 1 - best;
}

}  // namespace aisle
