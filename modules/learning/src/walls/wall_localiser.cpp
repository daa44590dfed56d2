#include "aisle/learning/walls/wall_localiser.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "aisle/core/square.hpp"
#include "aisle/learning/walls/scan_geometry.hpp"

namespace aisle {
namespace {

constexpr int kLayingIterations = 6;
constexpr double kKnownWallSigma_m = 0.01;  // least sigma of a wall's position
constexpr double kKnownWallSigma_rad = 0.3 * kDegree;
constexpr double kTelling_m = 1.5;  // with less wall in sight, the pose is not called doubtful

WallEstimate known_wall(const Wall& wall) {
  const double heading_rad = wall.segment.heading();
  WallEstimate known;
  known.facing = wall.is_orthogonal ? facing_of(heading_rad, kPi / 4) : Facing::kOblique;
  known.set_heading(wall.is_orthogonal ? heading_of(known.facing) : heading_rad);
  known.anchor = wall.segment.midpoint();
  known.extent = known.span_of(wall.segment);
  known.offset_weight = 1 / square(std::max(wall.sigma_m, kKnownWallSigma_m));
  known.heading_weight = 1 / square(kKnownWallSigma_rad);
  known.start = wall.start;
  known.end = wall.end;
  known.sightings = std::max(1, wall.sightings);
  return known;
}

bool has_axes(const WallMap& walls) {
  return walls.orthogonal_share() > 0;
}

}  // namespace

void WallLocaliserParams::describe(FieldList& fields) {
  fields.group("segments", segments);
  fields.group("motion", motion);
  fields.real("gate_m", gate_m, {0.02, 2}, "a segment farther from a wall is not matched with it");
  fields.real("reach_m", reach_m, {2, 100}, "walls farther away are ignored");
  fields.real("lost_share", lost_share, {0, 1},
              "if less of the seen length fits the walls, the pose is doubtful");
}

WallLocaliser::WallLocaliser(const WallLocaliserParams& params, const LaserScanner& laser,
                             const WallMap& walls, const UncertainPose2& T_map_vehicle)
    : params_(params),
      T_vehicle_laser_(laser.T_vehicle_laser),
      segmenter_(scan_geometry(laser), params.segments),
      aligner_(has_axes(walls) ? AlignmentParams{} : AlignmentParams::without_axes()),
      T_map_vehicle_(T_map_vehicle) {
  for (const Wall& wall : walls.walls) {
    index_.add(wall.segment, static_cast<int>(walls_.size()));
    walls_.push_back(known_wall(wall));
  }
}

void WallLocaliser::take_scan(std::span<const float> ranges_m, const Pose2& T_last_now) {
  T_map_vehicle_ = T_map_vehicle_ * UncertainPose2{T_last_now, params_.motion.covariance(T_last_now)};
  segmenter_.extract(ranges_m, seen_);
  const UncertainPose2 T_map_sensor = T_map_vehicle_ * UncertainPose2{T_vehicle_laser_};
  const Vec2 p_map = T_map_sensor.mean.position();
  index_.query(p_map, p_map, params_.reach_m, near_);
  const PosePrior prior{T_map_sensor.mean, T_map_sensor.covariance.inverse()};
  const Alignment alignment = aligner_.align(seen_, walls_, near_, prior, params_.gate_m, kLayingIterations);
  seen_m_ = alignment.seen_m;
  fitting_m_ = alignment.fitting_m;
  is_doubtful_ = alignment.seen_m > kTelling_m && alignment.fitting_share() < params_.lost_share;
  const UncertainPose2 laid{alignment.T_map_sensor,
                            (prior.information + alignment.wall_information).inverse()};
  T_map_vehicle_ = laid * UncertainPose2{T_vehicle_laser_.inverse()};
}

}  // namespace aisle
