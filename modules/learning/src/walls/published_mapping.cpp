#include "aisle/learning/walls/published_mapping.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/geometry/dominant_direction.hpp"
#include "aisle/learning/walls/scan_geometry.hpp"
#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/matching/wall_estimate.hpp"
#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr double kPredictedHeadingSigma_rad = 2 * kDegree;  // of the predicted heading that walls correct
constexpr double kLearnedEvery_rad = 8 * kDegree;
constexpr double kMarkLengthCap_m = 8;
constexpr double kOccurrenceGrowth = 0.1;  // growth of an end point's weight each time it is seen again
constexpr double kOccurrenceCap = 3;
constexpr double kPriorFloor_m = 0.03;
constexpr double kPriorShare = 0.1;  // sigma as a share of the distance since the last scan
constexpr double kPriorFlat = 0.05;  // share of the highest value that the prior leaves

double end_weight(int occurrences, double c) {
  return c * std::min(1 + kOccurrenceGrowth * occurrences, kOccurrenceCap);
}

class PublishedMapper {
 public:
  PublishedMapper(const LaserLog& log, const SegmentParams& segments, const PublishedParams& params,
                  double delay_s)
      : log_(log),
        params_(params),
        delay_s_(delay_s),
        odometry_(log.odometry),
        segmenter_(scan_geometry(log.laser()), segments),
        correlator_(params.signature) {}

  void take_scan(std::size_t scan) {
    const LaserScan& taken = log_.scans[scan];
    segmenter_.extract(scan_geometry(log_.laser_of(taken)), taken.ranges_m, seen_);
    double step_m = 0;
    if (scan == 0) {
      const auto frame = dominant_direction(seen_);
      pose_ = {0, 0, frame ? -frame->heading_rad : 0};
    } else {
      const Pose2 motion = between(sensor_by_odometry(scan - 1), sensor_by_odometry(scan));
      step_m = std::hypot(motion.x, motion.y);
      path_m_ += step_m;
      pose_ = pose_ * motion;
      if (params_.heading_from_walls) {
        const auto measured = heading_from_walls(seen_, pose_.theta, kPredictedHeadingSigma_rad);
        if (measured) pose_.theta = measured->heading_rad;
      }
    }
    place_view();
    choose_window();
    if (scan > 0 && view_.size() >= 2 && window_.size() >= 2) match(step_m);
    trajectory_.push_back(pose_);
    const bool due = scan == 0 || path_m_ - learned_at_m_ > params_.learned_every_m ||
                     std::abs(wrap_angle(pose_.theta - learned_heading_rad_)) > kLearnedEvery_rad;
    if (due) learn();
  }

  MapResult result() const {
    MapResult result;
    const Pose2 T_sensor_vehicle = log_.laser().T_vehicle_laser.inverse();
    for (const Pose2& pose : trajectory_) result.T_map_vehicle.push_back(pose * T_sensor_vehicle);
    result.T_vehicle_laser = log_.laser().T_vehicle_laser;
    result.T_map_vehicle_online = result.T_map_vehicle;
    result.path_m = path_m_;
    result.odometry_delay_s = delay_s_;
    result.has_dominant_direction = true;
    std::vector<OrthogonalSegment> all = model_;
    all.insert(all.end(), window_.begin(), window_.end());
    for (const OrthogonalSegment& s : all) {
      const auto ends = [](int occurrences) { return occurrences > 1 ? WallEnd::kSeen : WallEnd::kUnknown; };
      result.walls.walls.push_back({s.segment(), true, ends(s.min_occurrences), ends(s.max_occurrences),
                                    std::max({1, s.min_occurrences, s.max_occurrences}), 0});
    }
    return result;
  }

 private:
  Pose2 sensor_by_odometry(std::size_t scan) const {
    return odometry_.at(log_.scans[scan].time_s - delay_s_, log_.odometry.size()) *
           log_.laser().T_vehicle_laser;
  }

  /// Builds the local model: the scan's segments along an axis, at the estimated pose.
  void place_view() {
    view_.clear();
    for (const SensedSegment& s : seen_) {
      const PlacedSegment placed(s, pose_);
      const Facing facing = facing_of(placed.heading_rad, params_.axis_tolerance_rad);
      if (facing == Facing::kOblique) continue;
      const bool along_x = facing == Facing::kEast || facing == Facing::kWest;
      const Eigen::Index axis = along_x ? 0 : 1;
      const auto [low, high] = std::minmax(placed.segment.start[axis], placed.segment.end[axis]);
      view_.push_back({along_x, placed.centroid[1 - axis], {low, high}});
    }
  }

  /// Step 1 of Algorithm 3.
  void choose_window() {
    const auto outside = [&](const OrthogonalSegment& s) {
      const double along = s.along_x ? pose_.x : pose_.y, across = s.along_x ? pose_.y : pose_.x;
      return std::abs(s.coordinate_m - across) >= params_.window_m ||
             s.extent.min >= along + params_.window_m || s.extent.max <= along - params_.window_m;
    };
    model_.insert(model_.end(), window_.begin(), window_.end());
    const auto rest = std::stable_partition(model_.begin(), model_.end(), outside);
    window_.assign(rest, model_.end());
    model_.erase(rest, model_.end());
  }

  /// Algorithm 2 on both axes.
  void match(double step_m) {
    const Vec2 displacement(displacement_along(Vec2::UnitX(), step_m),
                            displacement_along(Vec2::UnitY(), step_m));
    pose_.x += displacement.x();
    pose_.y += displacement.y();
    for (OrthogonalSegment& s : view_) {
      const double along = s.along_x ? displacement.x() : displacement.y();
      s.coordinate_m += s.along_x ? displacement.y() : displacement.x();
      s.extent = {s.extent.min + along, s.extent.max + along};
    }
  }

  double displacement_along(const Vec2& axis, double step_m) {
    Signature sensed, learned;
    for (const OrthogonalSegment& s : view_) {
      mark({s.segment(), s.extent.length(), params_.end_weight, params_.end_weight}, axis, SymbolKinds::kOne,
           sensed);
    }
    for (const OrthogonalSegment& s : window_) {
      mark({s.segment(), std::min(s.extent.length(), kMarkLengthCap_m),
            end_weight(s.min_occurrences, params_.end_weight),
            end_weight(s.max_occurrences, params_.end_weight)},
           axis, SymbolKinds::kOne, learned);
    }
    sort_symbols(learned);
    const std::span<double> values = correlator_.correlate(sensed, learned);
    if (params_.odometry_prior) {
      const double sigma_m = kPriorFloor_m + kPriorShare * step_m;
      const double flat = kPriorFlat * *std::max_element(values.begin(), values.end());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double off = correlator_.displacement_m(i) / sigma_m;
        values[i] = (values[i] + flat) * std::exp(-0.5 * off * off);
      }
    }
    return correlator_.peak_m().value_or(0);
  }

  void learn() {
    window_ = update_model(window_, view_, params_.update);
    learned_at_m_ = path_m_;
    learned_heading_rad_ = pose_.theta;
  }

  const LaserLog& log_;
  const PublishedParams& params_;
  double delay_s_;
  OdometryTrack odometry_;
  RangeSegmenter segmenter_;
  SignatureCorrelator correlator_;
  std::vector<SensedSegment> seen_;
  std::vector<OrthogonalSegment> view_;
  std::vector<OrthogonalSegment> window_;  ///< L': the part of the model around the vehicle
  std::vector<OrthogonalSegment> model_;   ///< the rest of the model
  std::vector<Pose2> trajectory_;
  Pose2 pose_;
  double path_m_ = 0;
  double learned_at_m_ = 0;
  double learned_heading_rad_ = 0;
};

}  // namespace

std::vector<Pose2> odometry_poses(const LaserLog& log, const SegmentParams& segments,
                                  double odometry_delay_s) {
  const LaserScan& first = log.scans.front();
  RangeSegmenter segmenter(scan_geometry(log.laser_of(first)), segments);
  std::vector<SensedSegment> seen;
  segmenter.extract(first.ranges_m, seen);
  const auto frame = dominant_direction(seen);
  const OdometryTrack odometry(log.odometry);
  const auto vehicle_at = [&](const LaserScan& scan) {
    return odometry.at(scan.time_s - odometry_delay_s, log.odometry.size());
  };
  const double first_heading_rad = (frame ? -frame->heading_rad : 0) - log.laser().T_vehicle_laser.theta;
  const Pose2 T_map_odom = Pose2{0, 0, first_heading_rad} * vehicle_at(log.scans.front()).inverse();
  std::vector<Pose2> poses;
  for (const LaserScan& scan : log.scans) poses.push_back(T_map_odom * vehicle_at(scan));
  return poses;
}

MapResult build_published_map(const LaserLog& log, const SegmentParams& segments,
                              const PublishedParams& params, double odometry_delay_s, Progress& progress) {
  PublishedMapper mapper(log, segments, params, odometry_delay_s);
  for (std::size_t scan = 0; scan < log.scans.size(); ++scan) {
    mapper.take_scan(scan);
    progress.report("matching", scan + 1, log.scans.size());
  }
  return mapper.result();
}

}  // namespace aisle
