#pragma once
/// The multiweighted generalized Hough transform (C98 section II-C, Algorithm 1): which displacement fits a
/// pattern of weighted points best onto another?
///
/// The printed algorithm swaps its two patterns in two places. Here, as its text means it, P are points of
/// the TEMPLATE (the learned pattern) and Q of the INPUT (the seen one). For each angle gamma, each pair
/// votes for the displacement P - R(gamma) Q and, less, for the cells around it:
///
///   H(cell, gamma) += W_P W_Q / (1 + d1 / D0)      (6), d1 = distance of the cells' centres (7)
///
/// Angles turn the input about the origin of its coordinates. Give both patterns relative to the assumed
/// vehicle pose: then the displacement is the correction of that pose, and an angle error does not smear it.

#include <memory>
#include <optional>
#include <span>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct WeightedPoint {
  Vec2 position = Vec2::Zero();  ///< [m]
  double weight = 1;             ///< > 0, and such that the product of two is a normal floating-point number
};

struct MwghtParams {
  double cell_m = 0.02;
  double angle_step_rad = 0.25 * kDegree;
  double distance_scale_m = 0.15;  ///< D0
  double reach_m = 0.3;            ///< reach of a vote around its own cell: the neighbourhood NH
  double apart_m = 0.4;            ///< displacements this far from each other are different hypotheses,
  double apart_rad = 4 * kDegree;  ///< and so are angles

  void describe(FieldList& fields);
};

/// The search window: cells whose centres are within +-x, +-y of the origin, and angles within +-turn, all
/// multiples of the parameters' steps; at most 20,000 of each on each side.
struct MwghtWindow {
  double x_half_m = 0.5;
  double y_half_m = 0.5;
  double turn_half_rad = 3 * kDegree;
};

struct MwghtCell {
  int x = 0, y = 0, turn = 0;  ///< in cells and angle steps from the origin

  friend bool operator==(const MwghtCell&, const MwghtCell&) = default;
};

/// A maximum of H.
struct MwghtPeak {
  MwghtCell cell;
  double value = 0;    ///< H at the cell
  Pose2 displacement;  ///< refined to sub-cell accuracy by robust least squares: T such that T * Q lies on P
};

struct MwghtAnswer {
  MwghtPeak best;
  /// The greatest value among the cells that are a different hypothesis from the best; nullopt: no votes
  /// there.
  std::optional<MwghtPeak> runner_up;
  /// Of the best displacement (x, y, theta), from the spread and number of the pairs that fit. What they
  /// leave open (the turn, for a single point) is as uncertain as the window is wide.
  Mat3 covariance = Mat3::Zero();
};

class Mwght {
 public:
  explicit Mwght(const MwghtParams& params = {});
  Mwght(Mwght&&) noexcept;
  ~Mwght();

  /// The maximum by branch and bound: the same cell and the same value, bit for bit, as `match_exhaustively`.
  /// Of equal cells the first by (turn, y, x) wins. No allocation once warm.
  /// @return nullopt if no pair votes inside the window
  /// @throw std::invalid_argument for a window that is negative or too large
  std::optional<MwghtAnswer> match(std::span<const WeightedPoint> learned,
                                   std::span<const WeightedPoint> seen, const MwghtWindow& window);

  /// The published method: every vote into every cell. For comparison.
  std::optional<MwghtAnswer> match_exhaustively(std::span<const WeightedPoint> learned,
                                                std::span<const WeightedPoint> seen,
                                                const MwghtWindow& window);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace aisle
