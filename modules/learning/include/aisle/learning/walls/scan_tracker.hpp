#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/learning/walls/motion_noise.hpp"
#include "aisle/learning/walls/odometry_scale.hpp"
#include "aisle/matching/pose_alignment.hpp"
#include "aisle/matching/wall_estimate.hpp"

namespace aisle {

struct TrackerParams {
  MotionNoise motion;
  double gate_m = 0.25;       ///< a segment farther from a wall is not matched with it
  double same_wall_m = 0.12;  ///< a segment farther away across the wall is another wall
  double window_m = 20;       ///< walls not seen for this long a path are left to loop closing
  double unconfirmed_m = 3;   ///< a wall seen only once is forgotten after this long a path
  double keyframe_m = 0.25;
  double keyframe_rad = 8 * kDegree;
  double lost_share = 0.55;  ///< if less of the seen length fits, the pose is searched for
  double relocation_reach_m = 1.2;

  void describe(FieldList& fields);
};

/// A scan that was added to the local map.
struct Keyframe {
  std::size_t scan = 0;
  Pose2 T_track_sensor;
  double path_m = 0;
  Mat3 wall_information = Mat3::Zero();  ///< how well the walls fixed its pose
  bool relocated = false;                ///< the motion into it is a guess: the tracker was lost before
  CountedPath path;                      ///< in `track`
};

/// The tracked motion from one keyframe to another, with the wheels' distances scaled by this factor.
Pose2 relative_pose(const Keyframe& from, const Keyframe& to, double odometry_factor);

/// Tracks the sensor from scan to scan against the walls of the last segment of path: odometry predicts, the
/// walls' orthogonality corrects the heading, then the scan is fitted to the walls. The frame `track` never
/// jumps unless the tracker was lost; it drifts slowly. A step costs O(segments * walls in the window).
class ScanTracker {
 public:
  explicit ScanTracker(const TrackerParams& params);

  /// Takes one scan: its segments (sensor frame) and the sensor's motion since the last scan by odometry.
  /// Returns the sensor's pose in `track`. With `orthogonal` false the building has no dominant direction: no
  /// wall is taken to lie on an axis.
  Pose2 step(std::span<const SensedSegment> segments, const Pose2& T_last_now, bool orthogonal);
  /// The same with a motion whose noise is known better than `TrackerParams::motion` says.
  Pose2 step_by_motion(std::span<const SensedSegment> segments, const UncertainPose2& T_last_now,
                       bool orthogonal);

  /// Fits an earlier scan to the walls of the last segment of path, near a guess; nullopt if too little of it
  /// fits.
  std::optional<Pose2> lay_again(std::span<const SensedSegment> segments, const Pose2& T_track_guess);

  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  double path_m() const { return path_m_; }
  /// The factor by which the vehicle moves farther than its wheels count, as known now.
  double odometry_factor() const { return scale_.factor(); }
  std::size_t wall_count() const { return walls_.size(); }
  /// The number of scans in which the walls' orthogonality gave the heading.
  std::size_t headings_used() const { return headings_used_; }

 private:
  struct Explanation {
    Alignment alignment;
    CountedPath path;           ///< to the walls that it is fitted to
    bool is_as_counted = true;  ///< the vehicle moved as its wheels say
  };

  void trust_oblique_walls();
  void predict(const UncertainPose2& T_last_now);
  void correct_heading(std::span<const SensedSegment> segments);
  Alignment lay_onto_walls(std::span<const SensedSegment> segments);
  Explanation explain_motion(std::span<const SensedSegment> segments);
  Explanation lay_from(std::span<const SensedSegment> segments, const Vec2& motion_m);
  CountedPath path_to_walls() const;
  void correct_pose(const Alignment& alignment, const CountedPath& path_to_walls);
  bool relocate(std::span<const SensedSegment> segments);
  bool confirm_suspicion(const Pose2& T_sensor_found);
  bool keyframe_is_due() const;
  void learn(std::span<const SensedSegment> segments, const Mat3& wall_information);

  TrackerParams params_;
  WallUpdateParams update_;
  PoseAligner aligner_;
  UncertainPose2 T_track_sensor_;
  Pose2 T_track_last_;  ///< pose at the scan before
  Pose2 motion_;        ///< since then, by odometry
  OdometryScale scale_;
  std::vector<WallEstimate> walls_;
  std::vector<CountedPath> paths_;  ///< to each wall, when it was first seen
  std::vector<int> window_;
  std::vector<Keyframe> keyframes_;
  std::size_t scan_ = 0;
  double path_m_ = 0;
  std::size_t headings_used_ = 0;
  Pose2 T_sensor_suspected_;      ///< where the latest scans fit better ...
  double suspected_since_m_ = 0;  ///< ... since this path length ...
  int suspected_scans_ = 0;       ///< ... this many in a row
  bool relocated_ = false;
  bool orthogonal_ = true;
};

}  // namespace aisle
