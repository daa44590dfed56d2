#pragma once

#include <vector>

#include "aisle/learning/walls/loop_params.hpp"
#include "aisle/learning/walls/motion_noise.hpp"
#include "aisle/matching/pose_graph.hpp"
#include "walls/submap.hpp"
#include "walls/submap_matching.hpp"

namespace aisle {

/// Two submaps that show the same place.
struct LoopClosure {
  std::size_t older = 0;
  std::size_t newer = 0;
};

/// Recognises places: each finished submap is compared with those that are near in the graph and old by path
/// length. Agreement becomes a constraint of the pose graph, which then moves every submap.
class LoopCloser {
 public:
  LoopCloser(const LoopParams& params, const MotionNoise& motion) : params_(params), motion_(motion) {}

  /// Adds the next submap; `keyframes` are all so far. Returns true if a loop was closed. O(submaps) for the
  /// graph distances, and at most eight comparisons.
  bool add(Submap submap, std::span<const Keyframe> keyframes, bool orthogonal);

  /// Compares every submap once more, now that all are in place and little search is needed, and solves the
  /// graph.
  void finish(std::span<const Keyframe> keyframes);

  /// Recomputes all relative poses for a new scale factor of the wheels' distances.
  void restate_odometry(double odometry_factor, std::span<const Keyframe> keyframes);
  double odometry_factor() const { return odometry_factor_; }

  const std::vector<Submap>& submaps() const { return submaps_; }
  const std::vector<LoopClosure>& closures() const { return closures_; }
  Pose2 T_map_anchor(std::size_t submap) const { return graph_.pose(submap); }

 private:
  struct Candidate {
    std::size_t submap;
    double reach_m;
  };
  /// A fit from a large search needs a second submap that agrees.
  struct Pending {
    PoseConstraint constraint;
    Vec2 correction_m;
    bool taken = false;
  };

  Pose2 relative_pose_to(std::size_t submap, std::span<const Keyframe> keyframes) const;
  void connect_to_previous(std::span<const Keyframe> keyframes, bool orthogonal);
  bool close_loops(std::size_t submap, std::span<const Keyframe> keyframes);
  std::vector<double> distances_from(std::size_t submap) const;
  std::vector<Candidate> candidates(std::size_t submap) const;
  bool is_closed(std::size_t submap, std::size_t other) const;
  bool try_to_close(std::size_t submap, const Candidate& candidate, std::span<const Keyframe> keyframes);
  bool confirm(const Pending& pending);
  void take(const PoseConstraint& constraint);

  LoopParams params_;
  MotionNoise motion_;
  double odometry_factor_ = 1;
  std::vector<Submap> submaps_;
  PoseGraph graph_;
  std::vector<std::vector<std::size_t>> loops_of_submap_;
  std::vector<LoopClosure> closures_;
  std::vector<Pending> pending_;
};

}  // namespace aisle
