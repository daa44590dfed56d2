#include "aisle/learning/walls/map_building.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

#include "aisle/geometry/dominant_direction.hpp"
#include "aisle/learning/walls/odometry_delay.hpp"
#include "aisle/learning/walls/scan_geometry.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/learning/walls/scanner_calibration.hpp"
#include "walls/scan_mapping.hpp"
#include "walls/wall_adjustment.hpp"

namespace aisle {
namespace {

constexpr double kFrameShare = 0.6;      // scans with a clearer frame are used for the odometry delay
constexpr double kContradicted_m = 0.3;  // odometry that is off by more from scan to scan is said
constexpr double kContradicted_rad = 20 * kDegree;
constexpr double kFinalGate_m = 0.15;
constexpr int kFinalIterations = 4;
constexpr double kFinalSigma_m = 0.02;  // how far one scan may move from its place between the keyframes
constexpr double kFinalSigma_rad = 1 * kDegree;
constexpr double kFinalMargin_m = 0.3;

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class MapBuilder {
 public:
  MapBuilder(const LaserLog& log, const MapParams& params, const KnownOfLog& known)
      : log_(log),
        params_(params),
        known_(known),
        T_vehicle_laser_(log.laser().T_vehicle_laser),
        odometry_(log.odometry),
        delay_(odometry_, log.scan_period_s(), known.guessed_delay_s),
        segmenter_(scan_geometry(log.laser()), params.segments),
        mapping_(params) {}

  void take_scan(std::size_t scan) {
    segmenter_.extract(geometry_of(log_.scans[scan]), log_.scans[scan].ranges_m, seen_);
    place_on_first_laser(log_.scans[scan].laser);
    const Pose2 counted = counted_to(scan);
    if (known_.odometry_noise) {
      mapping_.step(seen_, counted);
    } else {
      mapping_.step_by_motion(seen_, motion_to(scan, counted));
    }
    online_.push_back(mapping_.T_map_sensor());
    if (!known_.mounting) learn_mounting(scan);
  }

  void finish_loops() { mapping_.finish_loops(); }
  std::vector<Pose2> after_loops() const { return mapping_.T_map_sensor_of_all(); }

  /// Adjusts keyframes and walls together; returns every scan's pose, moved along.
  std::vector<Pose2> adjust(const std::vector<Pose2>& T_map_sensor) {
    std::vector<std::size_t> scans;
    std::vector<Pose2> keyframes;
    for (const Keyframe& keyframe : mapping_.tracker().keyframes()) {
      scans.push_back(keyframe.scan);
      keyframes.push_back(T_map_sensor[keyframe.scan]);
    }
    WallAdjustment adjustment(mapping_.tracker().keyframes(), mapping_.segments(), keyframes,
                              params_.tracker.motion, mapping_.tracker().odometry_factor(),
                              mapping_.is_orthogonal());
    adjustment.run(params_.adjustment_rounds);
    walls_ = adjustment.walls();
    sightings_ = adjustment.sightings();
    return carried_along(mapping_.tracked(), scans, adjustment.T_map_sensor());
  }

  /// Fits one scan to the final walls.
  Pose2 settle(std::size_t scan, const Pose2& T_map_sensor) {
    const std::span<const SensedSegment> seen = mapping_.segments().of_scan(scan);
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
    const Pose2 T_sensor_vehicle = T_vehicle_laser_.inverse();
    for (Pose2& pose : T_map_sensor) pose = pose * T_sensor_vehicle;
    return T_map_sensor;
  }

  MapResult result() const {
    MapResult result;
    result.T_map_vehicle_online = of_vehicle(online_);
    result.path_m = mapping_.tracker().path_m();
    result.odometry_delay_s = delay_s();
    result.warnings = contradictions();
    result.T_vehicle_laser = T_vehicle_laser_;
    for (const LoopClosure& closure : mapping_.loops().closures()) {
      const auto scan = [&](std::size_t submap) {
        return mapping_.tracker().keyframes()[mapping_.loops().submaps()[submap].anchor_keyframe].scan;
      };
      result.loop_closures.emplace_back(scan(closure.older), scan(closure.newer));
    }
    result.has_dominant_direction = mapping_.is_orthogonal() && mapping_.shows_axes();
    return result;
  }

  WallMap draw(const std::vector<Pose2>& T_map_sensor) const {
    std::vector<PlacedScan> scans;
    for (const Keyframe& keyframe : mapping_.tracker().keyframes()) {
      const LaserScan& scan = log_.scans[keyframe.scan];
      scans.push_back({T_map_sensor[keyframe.scan] * T_first_laser(scan.laser), keyframe.path_m, &scan,
                       log_.laser_of(scan)});
    }
    return draw_walls(walls_, sightings_, scans, params_.drawn_length_m, params_.drawn_sightings);
  }

  const std::vector<Pose2>& tracked() const { return mapping_.tracked(); }

  /// The number of walls so far: the tracker's until they are adjusted.
  std::size_t wall_count() const { return walls_.empty() ? mapping_.tracker().wall_count() : walls_.size(); }

 private:
  double delay_s() const { return known_.odometry_delay_s.value_or(delay_.delay_s()); }

  Pose2 sensor_at(double time_s, std::size_t odometry_known) const {
    return odometry_.at(time_s - delay_s(), odometry_known) * T_vehicle_laser_;
  }

  /// A scanner of the log in the frame of the first one.
  Pose2 T_first_laser(std::size_t laser) const {
    return between(log_.laser().T_vehicle_laser, log_.lasers[laser].T_vehicle_laser);
  }

  /// The beams of a scan, with the motion during it if they were measured one after the other.
  ScanGeometry geometry_of(const LaserScan& scan) const {
    ScanGeometry geometry = scan_geometry(log_.laser_of(scan));
    const double half_s =
        scan.beams ? 0.5 * scan.beams->period_s * static_cast<double>(scan.ranges_m.size()) : 0;
    if (half_s == 0) return geometry;
    const Pose2 T_first_scan = T_first_laser(scan.laser);
    geometry.swept = between(sensor_at(scan.time_s - half_s, scan.odometry_known) * T_first_scan,
                             sensor_at(scan.time_s + half_s, scan.odometry_known) * T_first_scan);
    return geometry;
  }

  void place_on_first_laser(std::size_t laser) {
    if (laser == 0) return;
    for (SensedSegment& segment : seen_) segment = T_first_laser(laser) * segment;
  }

  /// Where the scanner sits shows wherever the vehicle turns.
  void learn_mounting(std::size_t scan) {
    const double time_s = log_.scans[scan].time_s;
    if (mounting_.add(mapping_.tracked().back(),
                      odometry_.at(time_s - delay_s(), log_.scans[scan].odometry_known)))
      T_vehicle_laser_ = mounting_.T_vehicle_laser(log_.laser().T_vehicle_laser);
  }

  /// The first scanner's motion from the previous scan to this one, by the odometry and by its own scans.
  UncertainPose2 motion_to(std::size_t scan, const Pose2& counted) {
    const LaserScan& now = log_.scans[scan];
    counted_since_ = counted_since_ * counted;
    if (now.laser != 0) return with_noise(counted);
    points_of(log_.laser_of(now), now.ranges_m, points_, geometry_of(now).swept);
    UncertainPose2 moved = scans_.step(points_, now.time_s, with_noise(counted_since_)).T_last_now;
    const Pose2 off = between(counted_since_, moved.mean);
    if (off.position().norm() > kContradicted_m || std::abs(off.theta) > kContradicted_rad)
      contradictions_.push_back({scan, off});
    moved.mean = counted * off;
    counted_since_ = {};
    return moved;
  }

  Problems contradictions() const {
    if (contradictions_.empty()) return {};
    const auto& [scan, off] = contradictions_.front();
    const std::size_t more = contradictions_.size() - 1;
    const std::string where = more == 0 ? "here" : fmt::format("here and at {} later scans", more);
    return {
        {{"", log_.scans[scan].line},
         fmt::format("the odometry contradicts the scans {}: here by {:.2f} m and {:.0f} degrees since the "
                     "scan before; the scans are believed as far as they tell",
                     where, off.position().norm(), to_degrees(std::abs(off.theta)))}};
  }

  UncertainPose2 with_noise(const Pose2& counted) const {
    return {counted, params_.tracker.motion.covariance(counted)};
  }

  /// The same by the odometry alone, at the delayed times.
  Pose2 counted_to(std::size_t scan) {
    const LaserScan& now = log_.scans[scan];
    const auto frame = dominant_direction(seen_);
    const bool clear = frame && frame->share > kFrameShare;
    delay_.add(now.time_s, now.odometry_known, clear ? std::optional(frame->heading_rad) : std::nullopt);
    if (scan == 0) return {};
    return between(sensor_at(log_.scans[scan - 1].time_s, now.odometry_known),
                   sensor_at(now.time_s, now.odometry_known));
  }

  const LaserLog& log_;
  const MapParams& params_;
  KnownOfLog known_;
  Pose2 T_vehicle_laser_;  ///< of the first scanner, as known now
  MountingEstimator mounting_;
  OdometryTrack odometry_;
  OdometryDelayEstimator delay_;
  RangeSegmenter segmenter_;
  ScanOdometry scans_;
  Pose2 counted_since_;  ///< by the odometry, since the first scanner's last scan
  std::vector<std::pair<std::size_t, Pose2>>
      contradictions_;  ///< scan; the motion by all, seen from the counted
  std::vector<Vec2> points_;
  ScanMapping mapping_;
  std::vector<SensedSegment> seen_;
  std::vector<Pose2> online_;
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
  fields.real("dominant_share_min", dominant_share_min, {0, 1},
              "with fewer than this share of scans whose walls give a heading, the building has no dominant "
              "direction");
  fields.count("adjustment_rounds", adjustment_rounds, {0, 20},
               "rounds of adjusting keyframes and walls together");
  fields.real("drawn_length_m", drawn_length_m, {0, 10}, "shorter walls are not written");
  fields.count("drawn_sightings", drawn_sightings, {1, 1000},
               "walls seen on fewer half-metre legs of the path are not written");
}

MapResult build_map(const LaserLog& log, const MapParams& params, const KnownOfLog& known, bool keep_stages,
                    Progress& progress) {
  const double start_s = cpu_s();
  std::vector<MapStage> stages;
  MapBuilder builder(log, params, known);
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
