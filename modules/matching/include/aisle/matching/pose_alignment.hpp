#pragma once

#include <span>
#include <vector>

#include "aisle/matching/wall_estimate.hpp"

namespace aisle {

/// Noise in comparing a sensed segment with its wall, beyond the segment's own deviations.
struct AlignmentParams {
  double wall_sigma_m = 0.01;     ///< of a wall seen once; falls with the root of its sightings
  double oblique_sigma_m = 0.03;  ///< oblique segments are often furniture or doors
  double oblique_sigma_rad = 4 * kDegree;
  double cauchy_m = 0.05;  ///< residuals beyond this count less and less
  double cauchy_rad = 1.5 * kDegree;
  int sightings_for_full_weight = 3;

  /// For a building in which every wall is oblique.
  static AlignmentParams without_axes() {
    return {.oblique_sigma_m = 0.01, .oblique_sigma_rad = 1 * kDegree};
  }
};

/// A guess of the pose with its information (inverse covariance) in the map's frame.
struct PosePrior {
  Pose2 T_map_sensor;
  Mat3 information = Mat3::Zero();
};

/// How a set of segments fits onto walls.
struct Alignment {
  Pose2 T_map_sensor;
  Mat3 wall_information = Mat3::Zero();  ///< of (x, y, theta) from the walls alone, without the prior
  double seen_m = 0;                     ///< length of all segments
  double matched_m = 0;                  ///< length of those matched with a wall
  double fitting_m = 0;                  ///< the same, weighted down the farther each lies from its wall

  /// Share of the seen length that is matched; 1 if nothing was seen.
  double matched_share() const { return seen_m > 0 ? matched_m / seen_m : 1; }
  /// The same for the fitting length.
  double fitting_share() const { return seen_m > 0 ? fitting_m / seen_m : 1; }
};

/// What one wall says about the sensor's position, in the map's frame.
struct WallConstraint {
  std::size_t wall = 0;         ///< its index in the given walls
  Vec2 normal = Vec2::UnitX();  ///< unit vector: it constrains the position along this only
  double weight = 0;            ///< 1 / variance [1/m^2]
};

/// Finds the pose at which the sensed segments fit the walls best: Gauss-Newton on each segment's offset from
/// its wall, n.(R c + t) - rho, and heading difference, both with a Cauchy weight, and on the prior. A wall
/// that may be parallel to most of the matched ones, within its heading uncertainty, does not constrain the
/// position along them. Segments are matched with walls again in the first iterations, within a gate that
/// narrows to half. O(iterations * segments * candidates); no allocation once warm.
class PoseAligner {
 public:
  explicit PoseAligner(const AlignmentParams& params) : params_(params) {}

  Alignment align(std::span<const SensedSegment> segments, std::span<const WallEstimate> walls,
                  std::span<const int> candidates, const PosePrior& prior, double gate_m, int iterations);

  /// Of the latest alignment, one for each matched segment. Valid until the next.
  std::span<const WallConstraint> constraints() const { return constraints_; }

 private:
  void associate_all(const Pose2& T_map_sensor, std::span<const SensedSegment> segments,
                     std::span<const WallEstimate> walls, std::span<const int> candidates,
                     const AssociationGate& gate);
  Vec2 normal_of_most(std::span<const SensedSegment> segments, std::span<const WallEstimate> walls) const;

  AlignmentParams params_;
  std::vector<int> wall_of_segment_;
  std::vector<WallConstraint> constraints_;
};

}  // namespace aisle
