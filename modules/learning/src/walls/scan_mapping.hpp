#pragma once

#include <optional>
#include <vector>

#include "aisle/learning/walls/map_building.hpp"
#include "walls/loop_closer.hpp"
#include "walls/scan_segments.hpp"

namespace aisle {

/// Poses of all scans from corrected poses of some: every scan keeps its tracked place relative to the
/// corrected scans before and after it, blended in between.
std::vector<Pose2> carried_along(const std::vector<Pose2>& tracked, const std::vector<std::size_t>& scans,
                                 const std::vector<Pose2>& corrected);

/// The part of mapping that goes along with the scans: tracking, submaps, loops.
class ScanMapping {
 public:
  explicit ScanMapping(const MapParams& params)
      : params_(params), tracker_(params.tracker), loops_(params.loops, params.tracker.motion) {}

  /// One scan: its segments and the sensor's motion since the last one by odometry.
  /// @return whether a loop was closed: poses of earlier scans are others now
  bool step(std::span<const SensedSegment> segments, const Pose2& T_last_now);

  /// Of the latest scan, as known now.
  Pose2 T_map_sensor() const { return T_map_track_ * tracked_.back(); }
  /// Of all scans, as known now.
  std::vector<Pose2> T_map_sensor_of_all() const;

  /// Where an earlier scan lies on the walls of the last path segment, near a guess, if it fits them.
  std::optional<Pose2> lay_again(std::size_t scan, const Pose2& T_map_guess);

  /// Looks for loops once more, now that every scan is in.
  void finish_loops();

  const std::vector<Pose2>& tracked() const { return tracked_; }
  const ScanSegments& segments() const { return segments_; }
  const ScanTracker& tracker() const { return tracker_; }
  const LoopCloser& loops() const { return loops_; }
  /// Walls may be taken for axes of the building.
  bool is_orthogonal() const { return orthogonal_; }
  bool shows_axes() const;

 private:
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
