#pragma once
/// A peak of H refined to sub-cell accuracy.

#include <span>
#include <vector>

#include "aisle/matching/mwght.hpp"

namespace aisle {

/// Fits the seen points to the nearest learned ones by weighted least squares, starting at a cell. Outliers
/// count less (Welsch's weight).
class MwghtRefinement {
 public:
  explicit MwghtRefinement(const MwghtParams& params) : params_(params) {}

  /// The displacement with its covariance. What the pairs leave open (the turn, for one point) stays at the
  /// cell and is as uncertain as the window is wide.
  UncertainPose2 refine(const MwghtCell& cell, std::span<const WeightedPoint> learned,
                        std::span<const WeightedPoint> seen, const MwghtWindow& window);

 private:
  struct Pair {
    std::size_t seen;
    Vec2 p_learned, p_seen;
    double weight;
  };
  /// A seen point with the learned point nearest to it now.
  struct Match {
    Vec2 lever;     ///< the seen point, turned
    Vec2 residual;  ///< from the learned to the displaced seen point [m]
    double weight, distance_m;
  };

  void pair_within_reach(const Pose2& start, std::span<const WeightedPoint> learned,
                         std::span<const WeightedPoint> seen);
  void match_nearest(const Pose2& displacement);
  double usual_distance();

  MwghtParams params_;
  std::vector<Pair> pairs_;
  std::vector<Match> matches_;
  std::vector<double> distances_;
};

}  // namespace aisle
