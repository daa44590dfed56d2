#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aisle/learning/walls/motion_noise.hpp"
#include "aisle/learning/walls/scan_tracker.hpp"
#include "aisle/maps/cell_index.hpp"
#include "walls/scan_segments.hpp"
#include "walls/wall_drawing.hpp"

namespace aisle {

/// Adjusts all keyframes and all walls together until they agree best: each keyframe's segments lie on their
/// walls, and motions between keyframes stay as tracked. A wall on the axes has one unknown (its coordinate),
/// an oblique one two. Robust Gauss-Newton on the sparse normal equations, with new associations in between.
class WallAdjustment {
 public:
  /// `T_map_sensor`: the keyframes' initial poses.
  WallAdjustment(std::span<const Keyframe> keyframes, const ScanSegments& segments,
                 std::vector<Pose2> T_map_sensor, const MotionNoise& motion, double odometry_factor,
                 bool orthogonal);

  void run(int rounds);

  const std::vector<Pose2>& T_map_sensor() const { return T_map_sensor_; }
  /// The walls used, with the number of segments on each as `sightings`.
  std::vector<WallEstimate> walls() const;
  /// Every segment used, at its final pose, with its index in walls().
  std::vector<WallSighting> sightings() const;

 private:
  struct Observation {
    std::size_t keyframe;
    const SensedSegment* segment;
    int wall = -1;
  };

  void associate_all(double gate_m);
  double solve(bool first_of_round);
  void add_motions();
  void add_observations();
  void apply(const Eigen::VectorXd& step);
  void find_near(const PlacedSegment& placed, double margin_m);

  std::span<const Keyframe> keyframes_;
  std::vector<Pose2> T_map_sensor_;
  MotionNoise motion_;
  double odometry_factor_;  ///< factor of the wheels' distances
  WallUpdateParams update_;
  double oblique_sigma_m_ =
      0.02;  ///< oblique segments are often furniture or doors; 0 where no wall has an axis
  double oblique_sigma_rad_ = 2 * kDegree;
  std::vector<Observation> observations_;  ///< long segments first: they make the most stable walls
  std::vector<WallEstimate> walls_;
  CellIndex index_;
  std::vector<int> near_;
  std::vector<int> unknown_of_wall_;  ///< index of the wall's first unknown; -1: seen too rarely to take part
  std::size_t unknowns_ = 0;
  struct Solver;
  struct SolverDeleter {
    void operator()(Solver* solver) const;
  };
  std::unique_ptr<Solver, SolverDeleter> solver_;
};

}  // namespace aisle
