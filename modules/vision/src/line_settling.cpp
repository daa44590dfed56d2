#include "line_settling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace aisle {
namespace {

constexpr double kBin_rows = 0.5;                 // of a profile across a line
constexpr int kBinsAbove = 8, kBinsBeneath = 14;  // of it
constexpr int kProfileBins = kBinsAbove + kBinsBeneath;
constexpr int kStepsPerBin = 2;                     // from one foot that is tried to the next
constexpr int kStepsAbove = 12, kStepsBeneath = 5;  // so far from the line they are
constexpr int kFeet = kStepsAbove + kStepsBeneath + 1;
constexpr double kStep_rows = kBin_rows / kStepsPerBin;
constexpr double kWall =
    0.15;  // of the depth: what is seen of a wall beneath the upper edge of its board ...
constexpr double kWallLeast_rows = 2.5;                    // ... but no less than this
constexpr double kEdgeBlur_rows = 0.75;                    // to either side of a sharp edge
constexpr std::array<double, 2> kShadows_rows = {1.5, 4};  // in which the shadow before a wall fades
constexpr double kRidge = 1e-6;                            // keeps apart what cannot be told apart

using Levels = Eigen::Vector3d;  ///< of the wall, what the floor at its foot has more, and its light more yet

/// What the brightness is at x rows beneath a foot is a sum of levels, each times one of these.
Levels shares_at(double x_rows, double shadow_rows) {
  const auto light_before = [&](double x) {
    return x > 0 ? x - shadow_rows * (1 - std::exp(-x / shadow_rows)) : 0;
  };
  return {
      1, std::clamp(0.5 + x_rows / (2 * kEdgeBlur_rows), 0.0, 1.0),
      (light_before(x_rows + kEdgeBlur_rows) - light_before(x_rows - kEdgeBlur_rows)) / (2 * kEdgeBlur_rows)};
}

/// The shares of all bins for all feet: by the steps from a foot to a bin's middle.
using FootShares = std::array<Levels, static_cast<std::size_t>(kProfileBins* kStepsPerBin + kFeet)>;

FootShares foot_shares(double shadow_rows) {
  FootShares shares;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const int steps = static_cast<int>(i) - kBinsAbove * kStepsPerBin - kStepsBeneath + kStepsPerBin / 2;
    shares[i] = shares_at(steps * kStep_rows, shadow_rows);
  }
  return shares;
}

/// Mean brightness above and beneath a line, all its columns together.
class FootProfile {
 public:
  FootProfile(const LevelView& view, const FloorLine& line) {
    for (int column = static_cast<int>(line.first_column); column <= line.last_column; ++column)
      add(view, column, line.row_at(column));
    for (int bin = 0; bin < kProfileBins; ++bin) square_ += count(bin) * mean(bin) * mean(bin);
  }

  /// How badly a foot so many steps beneath the line explains the profile.
  double misfit(int steps) const {
    static const std::array<FootShares, kShadows_rows.size()> shares_by_shadow = {
        foot_shares(kShadows_rows[0]), foot_shares(kShadows_rows[1])};
    double least = std::numeric_limits<double>::infinity();
    for (const FootShares& shares : shares_by_shadow) {
      Eigen::Matrix3d normal = kRidge * Eigen::Matrix3d::Identity();
      Levels right = Levels::Zero();
      for (int bin = 0; bin < kProfileBins; ++bin) {
        const Levels& share = shares[static_cast<std::size_t>(bin * kStepsPerBin - steps + kStepsBeneath)];
        normal += count(bin) * share * share.transpose();
        right += count(bin) * mean(bin) * share;
      }
      least = std::min(least, square_ - right.dot(normal.ldlt().solve(right)));
    }
    return least;
  }

 private:
  void add(const LevelView& view, int column, double edge) {
    const LevelView::Rows seen = view.seen(column);
    const double top = edge - kBinsAbove * kBin_rows;
    const double wall_rows = std::clamp(kWall * view.depth(edge), kWallLeast_rows, kBinsAbove * kBin_rows);
    const int first = std::max(seen.first, static_cast<int>(std::ceil(edge - wall_rows))),
              end = std::min(seen.end, static_cast<int>(std::ceil(top + kProfileBins * kBin_rows)));
    for (int row = first; row < end; ++row) {
      const auto bin =
          std::min(static_cast<std::size_t>((row - top) / kBin_rows), std::size_t{kProfileBins - 1});
      sums_[bin] += view.column(column)[row];
      ++counts_[bin];
    }
  }

  double count(int bin) const { return counts_[static_cast<std::size_t>(bin)]; }
  double mean(int bin) const {
    return sums_[static_cast<std::size_t>(bin)] / std::max(1, counts_[static_cast<std::size_t>(bin)]);
  }

  std::array<double, kProfileBins> sums_{};
  std::array<int, kProfileBins> counts_{};
  double square_ = 0;
};

}  // namespace

FloorLine settled_line(const LevelView& view, const FloorLine& line) {
  const FootProfile profile(view, line);
  std::array<double, kFeet> misfits{};
  for (int i = 0; i < kFeet; ++i) misfits[static_cast<std::size_t>(i)] = profile.misfit(i - kStepsAbove);
  const auto best = std::min_element(misfits.begin(), misfits.end());
  double steps = static_cast<double>(best - misfits.begin()) - kStepsAbove;
  if (best != misfits.begin() && best + 1 != misfits.end()) {
    const double bend = best[-1] - 2 * best[0] + best[1];
    if (bend > 0) steps += 0.5 * (best[-1] - best[1]) / bend;
  }
  FloorLine settled = line;
  settled.row_middle += steps * kStep_rows;
  return settled;
}

}  // namespace aisle
