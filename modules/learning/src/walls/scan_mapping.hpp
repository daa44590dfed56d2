#pragma once

#include <optional>
#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "walls/loop_closer.hpp"
#include "walls/scan_segments.hpp"

namespace aisle {

/// Poses of all scans, given corrected poses of some: every scan keeps its tracked pose relative to the
/// corrected scans before and after it, blended in between.
std::vector<Pose2> carried_along(const std::vector<Pose2>& tracked, const std::vector<std::size_t>& scans,
                                 const std::vector<Pose2>& corrected);

/// The online part of mapping: tracking, submaps, loops.
class ScanMapping {
 public:
  explicit ScanMapping(const MapParams& params)
      : params_(params), tracker_(params.tracker), loops_(params.loops, params.tracker.motion) {}

  /// Takes one scan: its segments and the sensor's motion since the last one by odometry.
  /// @return whether a loop was closed: then the poses of earlier scans have changed
  bool step(std::span<const SensedSegment> segments, const Pose2& T_last_now);
  /// The same with a motion of known noise.
  bool step_by_motion(std::span<const SensedSegment> segments, const UncertainPose2& T_last_now);

  /// Of the latest scan, as known now.
  Pose2 T_map_sensor() const { return T_map_track_ * tracked_.back(); }
  /// Of all scans, as known now.
  std::vector<Pose2> T_map_sensor_of_all() const;

  /// Fits an earlier scan to the walls of the last segment of path, near a guess; nullopt if it does not fit.
  std::optional<Pose2> lay_again(std::size_t scan, const Pose2& T_map_guess);

  /// Searches for loops once more, now that every scan is in.
  void finish_loops();

  const std::vector<Pose2>& tracked() const { return tracked_; }
  const ScanSegments& segments() const { return segments_; }
  const ScanTracker& tracker() const { return tracker_; }
  const LoopCloser& loops() const { return loops_; }
  /// Whether walls may lie on the building's axes.
  bool is_orthogonal() const { return orthogonal_; }
  bool shows_axes() const;

 private:
  bool keep(std::span<const SensedSegment> segments, const Pose2& T_track_sensor);
  bool submap_is_complete() const;
  bool close_submap();

  MapParams params_;
  ScanTracker tracker_;
  LoopCloser loops_;
  ScanSegments segments_;
  std::vector<Pose2> tracked_;
  Pose2 T_map_track_;
  std::size_t next_keyframe_ = 0;
  bool orthogonal_ = true;
};

}  // namespace aisle
