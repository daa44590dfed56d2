#include "walls/scan_mapping.hpp"

#include <cmath>

namespace aisle {
namespace {

constexpr std::size_t kFirstVerdict = 200;  // scans before deciding whether the building has axes
constexpr double kFactorRestated = 0.002;  // a larger change of the wheels' factor updates all relative poses

}  // namespace

std::vector<Pose2> carried_along(const std::vector<Pose2>& tracked, const std::vector<std::size_t>& scans,
                                 const std::vector<Pose2>& corrected) {
  std::vector<Pose2> all(tracked.size());
  for (std::size_t i = 0; i < scans.front(); ++i) {
    all[i] = corrected.front() * between(tracked[scans.front()], tracked[i]);
  }
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const bool last = k + 1 == scans.size();
    const std::size_t end = last ? tracked.size() : scans[k + 1];
    for (std::size_t i = scans[k]; i < end; ++i) {
      all[i] = corrected[k] * between(tracked[scans[k]], tracked[i]);
      if (last) continue;
      const Pose2 from_next = corrected[k + 1] * between(tracked[end], tracked[i]);
      all[i] = interpolate(all[i], from_next,
                           static_cast<double>(i - scans[k]) / static_cast<double>(end - scans[k]));
    }
  }
  return all;
}

bool ScanMapping::step(std::span<const SensedSegment> segments, const Pose2& T_last_now) {
  return keep(segments, tracker_.step(segments, T_last_now, orthogonal_));
}

bool ScanMapping::step_by_motion(std::span<const SensedSegment> segments, const UncertainPose2& T_last_now) {
  return keep(segments, tracker_.step_by_motion(segments, T_last_now, orthogonal_));
}

bool ScanMapping::keep(std::span<const SensedSegment> segments, const Pose2& T_track_sensor) {
  segments_.append(segments);
  tracked_.push_back(T_track_sensor);
  if (tracked_.size() >= kFirstVerdict && !shows_axes()) orthogonal_ = false;
  return submap_is_complete() && close_submap();
}

std::vector<Pose2> ScanMapping::T_map_sensor_of_all() const {
  if (loops_.submaps().empty()) return tracked_;
  std::vector<std::size_t> scans;
  std::vector<Pose2> corrected;
  for (std::size_t i = 0; i < loops_.submaps().size(); ++i) {
    scans.push_back(tracker_.keyframes()[loops_.submaps()[i].anchor_keyframe].scan);
    corrected.push_back(loops_.T_map_anchor(i));
  }
  return carried_along(tracked_, scans, corrected);
}

std::optional<Pose2> ScanMapping::lay_again(std::size_t scan, const Pose2& T_map_guess) {
  const auto T_track = tracker_.lay_again(segments_.of_scan(scan), T_map_track_.inverse() * T_map_guess);
  if (!T_track) return std::nullopt;
  return T_map_track_ * *T_track;
}

void ScanMapping::finish_loops() {
  if (next_keyframe_ < tracker_.keyframes().size()) close_submap();
  loops_.restate_odometry(tracker_.odometry_factor(), tracker_.keyframes());
  loops_.finish(tracker_.keyframes());
}

/// Once too few scans have shown the building's axes, no wall is taken to be on an axis any more.
bool ScanMapping::shows_axes() const {
  return static_cast<double>(tracker_.headings_used()) >=
         params_.dominant_share_min * static_cast<double>(tracked_.size());
}

bool ScanMapping::submap_is_complete() const {
  const std::vector<Keyframe>& keyframes = tracker_.keyframes();
  return next_keyframe_ < keyframes.size() &&
         keyframes.back().path_m - keyframes[next_keyframe_].path_m >= params_.loops.submap_m;
}

bool ScanMapping::close_submap() {
  const std::vector<Keyframe>& keyframes = tracker_.keyframes();
  const bool is_last = !submap_is_complete();
  const std::size_t last = is_last ? keyframes.size() - 1 : keyframes.size() - 2;
  WallUpdateParams update{.gate_m = params_.tracker.same_wall_m};
  if (!orthogonal_) update.axis_tolerance_rad = -1;
  const double factor = tracker_.odometry_factor();
  const bool restated = std::abs(factor - loops_.odometry_factor()) > kFactorRestated;
  if (restated) loops_.restate_odometry(factor, keyframes);
  const bool closed =
      loops_.add(build_submap(next_keyframe_, last, keyframes, segments_, update), keyframes, orthogonal_);
  next_keyframe_ = last + 1;
  const std::size_t newest = loops_.submaps().size() - 1;
  T_map_track_ = loops_.T_map_anchor(newest) * loops_.submaps()[newest].T_track_anchor.inverse();
  return closed || restated;
}

}  // namespace aisle
