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
    Vec2 p_learned, p_seen;
    double weight, distance_m;
  };

  void pair_nearest(const Pose2& displacement, std::span<const WeightedPoint> learned,
                    std::span<const WeightedPoint> seen);
  double usual_distance();

  MwghtParams params_;
  std::vector<Pair> pairs_;
  std::vector<double> distances_;
};

}  // namespace aisle
