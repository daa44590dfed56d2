#include "floor/line_settling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kStep_rows = 0.25;                 // between the floor points that are tried
constexpr int kStepsAbove = 12, kStepsBeneath = 5;  // how far from the line they reach
constexpr int kFloorPoints = kStepsAbove + kStepsBeneath + 1;
constexpr double kSample_rows = 0.5;  // of a profile across a line
constexpr double kAbove_rows = 2.5;   // of it: less than is seen of a skirting board
constexpr int kSamples = 19;
constexpr double kEdgeBlur_rows = 1;                     // to either side of a sharp edge
constexpr std::array<double, 2> kShadows_rows = {2, 8};  // in which the shadow before a wall fades
constexpr double kWallUneven = 1;  // usual change of a wall's brightness, in noise of a sample a row
constexpr double kRidge = 1e-6;    // keeps apart what cannot be distinguished
constexpr int kLineParts = 4;      // of a line, each with its own profile
constexpr int kPartColumns = 6;    // at least
constexpr double kTurn_rows = 0.2,
                 kTurnByDepth = 0.06;  // usual difference of the offsets of a line's ends
constexpr double kNoiseVariance = 1;   // of a column's profile, at least
constexpr int kRounds = 3;             // as a floor point farther up comes into view
constexpr double kSettled_rows = 0.3;

constexpr int kLevels = 5;
using Levels = Eigen::Matrix<double, kLevels, 1>;
using Profile = Eigen::Matrix<double, kSamples, 1>;
using Misfits = std::array<double, kFloorPoints>;

/// The mean over the blur of an edge.
template <class Function>
double blurred(Function function, double x_rows) {
  constexpr int kPoints = 8;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) sum += function(x_rows + kEdgeBlur_rows * ((2 * i + 1.0) / kPoints - 1));
  return sum / kPoints;
}

/// The brightness at x rows beneath a floor point is a sum of levels, each times one of these: the wall and
/// its change upwards, the step to the floor, and the light that the floor gains with the distance from the
/// wall.
Levels shares_at(double x_rows) {
  const auto gained = [&](double shadow_rows) {
    return blurred([&](double x) { return x > 0 ? 1 - std::exp(-x / shadow_rows) : 0; }, x_rows);
  };
  Levels shares;
  shares << 1, std::max(0.0, -x_rows), std::clamp(0.5 + x_rows / (2 * kEdgeBlur_rows), 0.0, 1.0),
      gained(kShadows_rows[0]), gained(kShadows_rows[1]);
  return shares;
}

/// How much of a profile a floor point explains: the length of the profile's projection.
using Explanation = Eigen::Matrix<double, kLevels, kSamples>;

Explanation explanation_of(double floor_point_rows) {
  Explanation shares;
  for (int i = 0; i < kSamples; ++i)
    shares.col(i) = shares_at(i * kSample_rows - kAbove_rows - floor_point_rows);
  Eigen::Matrix<double, kLevels, kLevels> normal = shares * shares.transpose();
  normal.diagonal().array() += kRidge;
  normal(1, 1) += 1 / square(kWallUneven);
  return normal.llt().matrixL().solve(shares);
}

double floor_point_rows(double index) {
  return (index - kStepsAbove) * kStep_rows;
}

std::array<Explanation, kFloorPoints> all_explanations() {
  std::array<Explanation, kFloorPoints> explanations;
  for (int i = 0; i < kFloorPoints; ++i)
    explanations[static_cast<std::size_t>(i)] = explanation_of(floor_point_rows(i));
  return explanations;
}

/// How badly each floor point explains the mean profile of some columns; all equal where no column
/// shows the whole profile.
Misfits misfits_of(const LevelView& view, const FloorLine& line, int first, int end) {
  static const std::array<Explanation, kFloorPoints> explanations = all_explanations();
  Profile profile = Profile::Zero();
  int columns = 0;
  for (int column = first; column < end; ++column) {
    const LevelView::Rows seen = view.seen(column);
    const double top = line.row_at(column) - kAbove_rows, bottom = top + (kSamples - 1) * kSample_rows;
    if (top < seen.first || bottom >= seen.end - 1) continue;
    ++columns;
    for (int i = 0; i < kSamples; ++i) {
      const double row = top + i * kSample_rows;
      const std::uint8_t* grey = view.column(column) + static_cast<int>(row);
      profile[i] += grey[0] + (row - std::floor(row)) * (grey[1] - grey[0]);
    }
  }
  Misfits misfits{};
  if (columns == 0) return misfits;
  for (std::size_t i = 0; i < kFloorPoints; ++i)
    misfits[i] = (profile.squaredNorm() - (explanations[i] * profile).squaredNorm()) / columns;
  return misfits;
}

/// How far beneath a line its floor point is at its first and its last column.
struct Ends {
  double first_rows = 0, last_rows = 0;
};

/// The misfits of a line's parts from left to right.
class PartMisfits {
 public:
  PartMisfits(const LevelView& view, const FloorLine& line) {
    const int first = static_cast<int>(line.first_column),
              columns = static_cast<int>(line.last_column) - first + 1;
    count_ = std::clamp(columns / kPartColumns, 1, kLineParts);
    for (int part = 0; part < count_; ++part) {
      Misfits& misfits = parts_[static_cast<std::size_t>(part)];
      misfits =
          misfits_of(view, line, first + columns * part / count_, first + columns * (part + 1) / count_);
      least_ += *std::min_element(misfits.begin(), misfits.end());
    }
    turn_usual_ = kTurn_rows + kTurnByDepth * std::abs(line.slope) * columns;
  }

  /// The offsets that explain all parts best and do not differ by more than usual.
  Ends best() const {
    const double variance = std::max(kNoiseVariance, least_ / (count_ * (kSamples - kLevels)));
    double least = std::numeric_limits<double>::infinity();
    int best_first = 0, best_last = 0;
    for (int first = 0; first < kFloorPoints; ++first) {
      for (int last = 0; last < kFloorPoints; ++last) {
        const double turn = (last - first) * kStep_rows / turn_usual_;
        const double cost = sum(first, last) + variance * square(turn);
        if (cost >= least) continue;
        least = cost;
        best_first = first;
        best_last = last;
      }
    }
    const double off = between_steps(best_first, best_last);
    return {floor_point_rows(best_first + off), floor_point_rows(best_last + off)};
  }

 private:
  double sum(int first, int last) const {
    double sum = 0;
    for (int part = 0; part < count_; ++part) {
      const double floor_point = first + (last - first) * (part + 0.5) / count_;
      const auto below = std::min(static_cast<std::size_t>(floor_point), std::size_t{kFloorPoints - 2});
      const Misfits& misfits = parts_[static_cast<std::size_t>(part)];
      sum +=
          misfits[below] + (floor_point - static_cast<double>(below)) * (misfits[below + 1] - misfits[below]);
    }
    return sum;
  }

  double between_steps(int first, int last) const {
    if (std::min(first, last) == 0 || std::max(first, last) == kFloorPoints - 1) return 0;
    const double before = sum(first - 1, last - 1), here = sum(first, last), after = sum(first + 1, last + 1);
    const double bend = before - 2 * here + after;
    return bend > 0 ? std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) : 0;
  }

  int count_ = 0;
  std::array<Misfits, kLineParts> parts_{};
  double least_ = 0;
  double turn_usual_ = 0;
};

}  // namespace

FloorLine settled_line(const LevelView& view, const FloorLine& line) {
  FloorLine settled = line;
  for (int round = 0; round < kRounds; ++round) {
    const Ends ends = PartMisfits(view, settled).best();
    settled.row_middle += 0.5 * (ends.first_rows + ends.last_rows);
    settled.slope += (ends.last_rows - ends.first_rows) / (settled.last_column - settled.first_column);
    if (std::max(std::abs(ends.first_rows), std::abs(ends.last_rows)) < kSettled_rows) break;
  }
  return settled;
}

}  // namespace aisle
