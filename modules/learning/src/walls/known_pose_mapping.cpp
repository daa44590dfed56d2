#include "aisle/learning/walls/known_pose_mapping.hpp"

#include <cmath>
#include <vector>

#include "aisle/learning/walls/floor_of_log.hpp"
#include "aisle/learning/walls/scan_geometry.hpp"
#include "walls/wall_adjustment.hpp"

namespace aisle {
namespace {

constexpr double kNewView_m = 0.2;  // scans from nearer than this show the same
constexpr double kNewView_rad = 10 * kDegree;

/// The log as far as its poses are known.
struct PlacedLog {
  LaserLog log;                      ///< the scans with a pose alone
  std::vector<Pose2> T_map_vehicle;  ///< one per scan of it
  std::vector<bool> follows;         ///< the scan before it in the whole log has a pose, too

  PlacedLog(const LaserLog& whole, std::span<const std::optional<Pose2>> poses) {
    log.lasers = whole.lasers;
    for (std::size_t i = 0; i < whole.scans.size(); ++i) {
      if (!poses[i]) continue;
      log.scans.push_back(whole.scans[i]);
      T_map_vehicle.push_back(*poses[i]);
      follows.push_back(i > 0 && poses[i - 1].has_value());
    }
  }
};

class KnownPoseMapper {
 public:
  KnownPoseMapper(const PlacedLog& placed, const MapParams& params)
      : placed_(placed), params_(params), segmenter_(scan_geometry(placed.log.laser()), params.segments) {}

  WallMap walls(bool has_dominant_direction) {
    choose_keyframes();
    WallAdjustment at_poses(keyframes_, segments_, T_map_sensor_, params_.tracker.motion, 1,
                            has_dominant_direction);
    at_poses.find_walls();
    return draw_walls(at_poses.walls(), at_poses.sightings(), scans_, params_.drawn_length_m,
                      params_.drawn_sightings);
  }

 private:
  void choose_keyframes() {
    double path_m = 0;
    bool has_gap = false;
    for (std::size_t i = 0; i < placed_.log.scans.size(); ++i) {
      const Pose2& T = placed_.T_map_vehicle[i];
      has_gap |= !placed_.follows[i];
      if (i > 0 && placed_.follows[i]) path_m += between(placed_.T_map_vehicle[i - 1], T).position().norm();
      if (!has_gap && !is_new_view(i)) continue;
      add_keyframe(i, path_m, !has_gap);
      has_gap = false;
    }
  }

  bool is_new_view(std::size_t scan) const {
    const Pose2 moved = between(placed_.T_map_vehicle[keyframes_.back().scan], placed_.T_map_vehicle[scan]);
    return moved.position().norm() >= kNewView_m || std::abs(moved.theta) >= kNewView_rad ||
           placed_.log.scans[scan].laser != placed_.log.scans[keyframes_.back().scan].laser;
  }

  void add_keyframe(std::size_t index, double path_m, bool follows) {
    const LaserScan& scan = placed_.log.scans[index];
    const LaserScanner laser = placed_.log.laser_of(scan);
    ScanGeometry geometry = scan_geometry(laser);
    geometry.swept = swept_during(index);
    segmenter_.extract(geometry, scan.ranges_m, seen_);
    const Pose2& T_vehicle_first = placed_.log.laser().T_vehicle_laser;
    const Pose2 T_first_laser = between(T_vehicle_first, laser.T_vehicle_laser);
    for (SensedSegment& segment : seen_) segment = T_first_laser * segment;
    while (segments_.scan_count() < index) segments_.append({});
    segments_.append(seen_);
    T_map_sensor_.push_back(placed_.T_map_vehicle[index] * T_vehicle_first);
    keyframes_.push_back(
        {.scan = index, .T_track_sensor = T_map_sensor_.back(), .path_m = path_m, .path = {}});
    scans_.push_back({placed_.T_map_vehicle[index] * laser.T_vehicle_laser, path_m, &scan, laser, follows});
  }

  /// The scanner's motion during a scan whose beams were measured one after the other, by the poses around.
  Pose2 swept_during(std::size_t index) const {
    const LaserScan& scan = placed_.log.scans[index];
    if (!scan.beams || index == 0 || !placed_.follows[index]) return {};
    const double since_s = scan.time_s - placed_.log.scans[index - 1].time_s;
    const double during_s = scan.beams->period_s * static_cast<double>(scan.ranges_m.size());
    if (!(since_s > 0)) return {};
    const Pose2 moved = between(placed_.T_map_vehicle[index - 1], placed_.T_map_vehicle[index]);
    const double share = during_s / since_s;
    const Pose2& T_vehicle_laser = placed_.log.lasers[scan.laser].T_vehicle_laser;
    return T_vehicle_laser.inverse() * Pose2{share * moved.x, share * moved.y, share * moved.theta} *
           T_vehicle_laser;
  }

  const PlacedLog& placed_;
  const MapParams& params_;
  RangeSegmenter segmenter_;
  std::vector<SensedSegment> seen_;
  ScanSegments segments_;
  std::vector<Keyframe> keyframes_;
  std::vector<Pose2> T_map_sensor_;
  std::vector<PlacedScan> scans_;
};

}  // namespace

KnownPoseMap map_at_poses(const LaserLog& log, std::span<const std::optional<Pose2>> T_map_vehicle,
                          bool has_dominant_direction, const MapParams& params) {
  const PlacedLog placed(log, T_map_vehicle);
  return {KnownPoseMapper(placed, params).walls(has_dominant_direction),
          floor_of_log(placed.log, placed.T_map_vehicle)};
}

}  // namespace aisle
