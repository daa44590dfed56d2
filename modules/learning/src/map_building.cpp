#include "aisle/learning/map_building.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "aisle/geometry/dominant_direction.hpp"
#include "aisle/learning/odometry_delay.hpp"
#include "beam_fan.hpp"
#include "loop_closer.hpp"
#include "scan_segments.hpp"
#include "wall_adjustment.hpp"

namespace aisle {
namespace {

constexpr double kFrameShare = 0.6;  // a scan that shows its frame so clearly witnesses the odometry delay
constexpr std::size_t kFirstVerdict = 200;  // scans before the building's angles are judged
constexpr double kFinalGate_m = 0.15;
constexpr int kFinalIterations = 4;
constexpr double kFinalSigma_m = 0.02;  // how far one scan may leave its place between the keyframes
constexpr double kFinalSigma_rad = 1 * kDegree;
constexpr double kFinalMargin_m = 0.3;

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Poses of all scans from corrected poses of some: every scan keeps its tracked place relative to the
/// corrected scans before and after it, blended in between.
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

class MapBuilder {
 public:
  MapBuilder(const LaserLog& log, const MapParams& params, std::optional<double> odometry_delay_s)
      : log_(log),
        params_(params),
        given_delay_s_(odometry_delay_s),
        odometry_(log.odometry),
        delay_(odometry_, log.scan_period_s()),
        segmenter_(beam_fan(log.laser), params.segments),
        tracker_(params.tracker),
        loops_(params.loops, params.tracker.motion) {}

  void take_scan(std::size_t scan) {
    segmenter_.extract(log_.scans[scan].ranges_m, seen_);
    segments_.append(seen_);
    tracked_.push_back(tracker_.step(seen_, motion_to(scan), orthogonal_));
    judge_angles();
    if (submap_is_complete()) close_submap();
    online_.push_back(T_map_track_ * tracked_.back());
  }

  void finish_loops() {
    if (next_keyframe_ < tracker_.keyframes().size()) close_submap();
    loops_.finish(tracker_.keyframes());
  }

  std::vector<Pose2> after_loops() const {
    std::vector<std::size_t> scans;
    std::vector<Pose2> corrected;
    for (std::size_t i = 0; i < loops_.submaps().size(); ++i) {
      scans.push_back(tracker_.keyframes()[loops_.submaps()[i].anchor_keyframe].scan);
      corrected.push_back(loops_.T_map_anchor(i));
    }
    return carried_along(tracked_, scans, corrected);
  }

  /// Adjusts keyframes and walls together; returns every scan's pose carried along.
  std::vector<Pose2> adjust(const std::vector<Pose2>& T_map_sensor) {
    std::vector<std::size_t> scans;
    std::vector<Pose2> keyframes;
    for (const Keyframe& keyframe : tracker_.keyframes()) {
      scans.push_back(keyframe.scan);
      keyframes.push_back(T_map_sensor[keyframe.scan]);
    }
    WallAdjustment adjustment(tracker_.keyframes(), segments_, keyframes, params_.tracker.motion,
                              orthogonal_);
    adjustment.run(params_.adjustment_rounds);
    walls_ = adjustment.walls();
    sightings_ = adjustment.sightings();
    return carried_along(tracked_, scans, adjustment.T_map_sensor());
  }

  /// Lays one scan onto the final walls.
  Pose2 settle(std::size_t scan, const Pose2& T_map_sensor) {
    const std::span<const SensedSegment> seen = segments_.of_scan(scan);
    if (seen.empty()) return T_map_sensor;
    Vec2 low = T_map_sensor.position(), high = low;
    for (const SensedSegment& s : seen) {
      for (const Vec2& end : {T_map_sensor * s.segment.start, T_map_sensor * s.segment.end}) {
        low = low.cwiseMin(end);
        high = high.cwiseMax(end);
      }
    }
    index_.query(low, high, kFinalMargin_m, near_);
    const Vec3 sigma(kFinalSigma_m, kFinalSigma_m, kFinalSigma_rad);
    const PosePrior prior{T_map_sensor, sigma.cwiseAbs2().cwiseInverse().asDiagonal()};
    return final_aligner_.align(seen, walls_, near_, prior, kFinalGate_m, kFinalIterations).T_map_sensor;
  }

  void index_walls() {
    for (std::size_t w = 0; w < walls_.size(); ++w) index_.add(walls_[w].segment(), static_cast<int>(w));
  }

  std::vector<Pose2> of_vehicle(std::vector<Pose2> T_map_sensor) const {
    const Pose2 T_sensor_vehicle = log_.laser.T_vehicle_laser.inverse();
    for (Pose2& pose : T_map_sensor) pose = pose * T_sensor_vehicle;
    return T_map_sensor;
  }

  MapResult result() const {
    MapResult result;
    result.T_map_vehicle_online = of_vehicle(online_);
    result.path_m = tracker_.path_m();
    result.odometry_delay_s = delay_s();
    for (const LoopClosure& closure : loops_.closures()) {
      const auto scan = [&](std::size_t submap) {
        return tracker_.keyframes()[loops_.submaps()[submap].anchor_keyframe].scan;
      };
      result.loop_closures.emplace_back(scan(closure.older), scan(closure.newer));
    }
    result.has_dominant_direction = orthogonal_ && shows_axes();
    return result;
  }

  WallMap draw(const std::vector<Pose2>& T_map_sensor) const {
    std::vector<PlacedScan> scans;
    for (const Keyframe& keyframe : tracker_.keyframes()) {
      scans.push_back({T_map_sensor[keyframe.scan], keyframe.path_m, &log_.scans[keyframe.scan]});
    }
    return draw_walls(walls_, sightings_, scans, log_.laser, params_.drawn_length_m, params_.drawn_sightings);
  }

  const std::vector<Pose2>& tracked() const { return tracked_; }

  /// Walls learned so far: the tracker's, until they are adjusted.
  std::size_t wall_count() const { return walls_.empty() ? tracker_.wall_count() : walls_.size(); }

 private:
  double delay_s() const { return given_delay_s_.value_or(delay_.delay_s()); }

  /// The sensor's motion from the scan before to this one, by odometry at the times that the delay says.
  Pose2 motion_to(std::size_t scan) {
    const LaserScan& now = log_.scans[scan];
    const auto frame = dominant_direction(seen_);
    const bool clear = frame && frame->share > kFrameShare;
    delay_.add(now.time_s, now.odometry_known, clear ? std::optional(frame->heading_rad) : std::nullopt);
    if (scan == 0) return {};
    const auto sensor_at = [&](double time_s) {
      return odometry_.at(time_s - delay_s(), now.odometry_known) * log_.laser.T_vehicle_laser;
    };
    return between(sensor_at(log_.scans[scan - 1].time_s), sensor_at(now.time_s));
  }

  /// Once too few scans have shown the building's axes, no wall is taken for one any more.
  void judge_angles() {
    if (tracked_.size() >= kFirstVerdict && !shows_axes()) orthogonal_ = false;
  }

  bool shows_axes() const {
    return static_cast<double>(tracker_.headings_used()) >=
           params_.dominant_share_min * static_cast<double>(tracked_.size());
  }

  bool submap_is_complete() const {
    const std::vector<Keyframe>& keyframes = tracker_.keyframes();
    return next_keyframe_ < keyframes.size() &&
           keyframes.back().path_m - keyframes[next_keyframe_].path_m >= params_.loops.submap_m;
  }

  void close_submap() {
    const std::vector<Keyframe>& keyframes = tracker_.keyframes();
    const bool is_last = !submap_is_complete();
    const std::size_t last = is_last ? keyframes.size() - 1 : keyframes.size() - 2;
    WallUpdateParams update;
    if (!orthogonal_) update.axis_tolerance_rad = -1;
    loops_.add(build_submap(next_keyframe_, last, keyframes, segments_, update), keyframes, orthogonal_);
    next_keyframe_ = last + 1;
    const std::size_t newest = loops_.submaps().size() - 1;
    T_map_track_ = loops_.T_map_anchor(newest) * loops_.submaps()[newest].T_track_anchor.inverse();
  }

  const LaserLog& log_;
  const MapParams& params_;
  std::optional<double> given_delay_s_;
  OdometryTrack odometry_;
  OdometryDelayEstimator delay_;
  RangeSegmenter segmenter_;
  ScanTracker tracker_;
  LoopCloser loops_;
  std::vector<SensedSegment> seen_;
  ScanSegments segments_;
  std::vector<Pose2> tracked_;
  std::vector<Pose2> online_;
  Pose2 T_map_track_;
  std::size_t next_keyframe_ = 0;
  bool orthogonal_ = true;
  std::vector<WallEstimate> walls_;
  std::vector<WallSighting> sightings_;
  CellIndex index_;
  std::vector<int> near_;
  PoseAligner final_aligner_{AlignmentParams{.sightings_for_full_weight = 1}};
};

}  // namespace

void MapParams::describe(FieldList& fields) {
  fields.group("segments", segments);
  fields.group("tracker", tracker);
  fields.group("loops", loops);
  fields.real(
      "dominant_share_min", dominant_share_min, {0, 1},
      "share of the scans whose walls must give a heading, or the building has no dominant direction");
  fields.count("adjustment_rounds", adjustment_rounds, {0, 20},
               "rounds of adjusting keyframes and walls together");
  fields.real("drawn_length_m", drawn_length_m, {0, 10}, "shorter walls are not written");
  fields.count("drawn_sightings", drawn_sightings, {1, 1000},
               "walls seen on fewer legs of half a metre of way are not written");
}

MapResult build_map(const LaserLog& log, const MapParams& params, std::optional<double> odometry_delay_s,
                    bool keep_stages, Progress& progress) {
  const double start_s = cpu_s();
  std::vector<MapStage> stages;
  MapBuilder builder(log, params, odometry_delay_s);
  const auto keep = [&](const char* name, const std::vector<Pose2>& T_map_sensor) {
    if (!keep_stages) return;
    stages.push_back({name, builder.of_vehicle(T_map_sensor), builder.wall_count(), cpu_s() - start_s});
  };

  const std::size_t scans = log.scans.size();
  for (std::size_t scan = 0; scan < scans; ++scan) {
    builder.take_scan(scan);
    progress.report("tracking", scan + 1, scans);
  }
  keep("tracked", builder.tracked());
  builder.finish_loops();
  std::vector<Pose2> T_map_sensor = builder.after_loops();
  keep("loops closed", T_map_sensor);
  T_map_sensor = builder.adjust(T_map_sensor);
  keep("walls adjusted", T_map_sensor);
  builder.index_walls();
  for (std::size_t scan = 0; scan < scans; ++scan) {
    T_map_sensor[scan] = builder.settle(scan, T_map_sensor[scan]);
    progress.report("settling", scan + 1, scans);
  }
  keep("every scan settled", T_map_sensor);

  MapResult result = builder.result();
  result.walls = builder.draw(T_map_sensor);
  result.T_map_vehicle = builder.of_vehicle(std::move(T_map_sensor));
  result.stages = std::move(stages);
  return result;
}

}  // namespace aisle
