#pragma once
/// A peak of H refined below its cell.

#include <span>
#include <vector>

#include "aisle/matching/mwght.hpp"

namespace aisle {

/// Lays the seen points onto the learned ones nearest to them by weighted least squares, starting at a cell.
/// What lies farther off than others counts less (Welsch's weight).
class MwghtRefinement {
 public:
  explicit MwghtRefinement(const MwghtParams& params) : params_(params) {}

  /// The displacement with its covariance. What the pairs do not say (the turn, of one point) remains at the
  /// cell, as uncertain as the window is wide.
  UncertainPose2 refine(const MwghtCell& cell, std::span<const WeightedPoint> learned,
                        std::span<const WeightedPoint> seen, const MwghtWindow& window);

 private:
  struct Pair {
    std::size_t seen;
    Vec2 p_learned, p_seen;
    double weight;
  };
  /// A seen point with the learned point nearest to it at present.
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
