#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A measured pose of node `to` in the frame of node `from`.
struct PoseConstraint {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 T_from_to;
  Mat3 information = Mat3::Identity();  ///< inverse covariance of (x, y, theta), in the frame of `from`
};

/// Least-squares pose graph. Odometry constraints count fully, loop closures with a Cauchy loss, so that a
/// wrong one cannot distort the graph; headings may have priors of their own. The first node is fixed.
class PoseGraph {
 public:
  PoseGraph();
  ~PoseGraph();
  PoseGraph(PoseGraph&&) noexcept;
  PoseGraph& operator=(PoseGraph&&) noexcept;

  /// Adds a node at a first guess of its pose and returns its index.
  std::size_t add_node(const Pose2& guess);
  /// The node's heading is about `heading_rad` in the graph's frame (Cauchy loss of two sigmas).
  void add_heading_prior(std::size_t node, double heading_rad, double sigma_rad);
  /// @return its index among the odometry constraints
  std::size_t add_odometry(const PoseConstraint& constraint);
  /// Replaces the measurement of an odometry constraint by a better one.
  void set_odometry(std::size_t index, const Pose2& T_from_to);
  /// `cauchy` is the number of sigmas beyond which the constraint counts less and less.
  void add_loop_closure(const PoseConstraint& constraint, double cauchy = 3);

  /// Moves all nodes but the first to the least-squares solution. A consistent graph is left as it is.
  void optimise(int iterations_max = 10);

  std::size_t size() const;
  Pose2 pose(std::size_t node) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace aisle
