#include "aisle/matching/pose_alignment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "aisle/core/cauchy.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"

namespace aisle {
namespace {

constexpr int kAssociationRounds = 4;
constexpr double kSettledStep = 1e-4;  // [m, rad]: further iterations change nothing
constexpr double kHeadingGate_rad = 6 * kDegree;
constexpr double kFirstHeadingGateMax_rad = 20 * kDegree;
constexpr double kOverlapMin_m = 0.1;
constexpr double kParallelSigmas = 2;  // walls whose headings differ by less may be parallel

/// The gate of one round: wide at first, when the pose is only a guess.
AssociationGate gate_in_round(int round, double gate_m, const Mat3& prior_information) {
  const double shrink = round == 0 ? 1.0 : round == 1 ? 0.7 : 0.5;
  const double heading_sigma_rad = std::sqrt(1 / std::max(1e-9, prior_information(2, 2)));
  const double heading_rad =
      round == 0 ? std::min(kFirstHeadingGateMax_rad, kHeadingGate_rad + 2 * heading_sigma_rad)
                 : kHeadingGate_rad;
  return {gate_m * shrink, heading_rad, kOverlapMin_m};
}

/// Walls that may be parallel to most of the others are treated as parallel: they do not constrain the
/// position along them. If one was learned with a yaw error, what it seems to say is that error, the same in
/// every scan.
Vec2 normal_to_trust(const WallEstimate& wall, const Vec2& normal_of_most, double parallel_cosine) {
  const double cosine = wall.normal.dot(normal_of_most);
  if (std::abs(cosine) < parallel_cosine) return wall.normal;
  return cosine > 0 ? normal_of_most : -normal_of_most;
}

}  // namespace

/// The normal, up to its sign, that most matched wall length has.
Vec2 PoseAligner::normal_of_most(std::span<const SensedSegment> segments,
                                 std::span<const WallEstimate> walls) const {
  Vec2 doubled = Vec2::Zero();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (wall_of_segment_[i] < 0) continue;
    const Vec2& normal = walls[static_cast<std::size_t>(wall_of_segment_[i])].normal;
    doubled +=
        segments[i].length_m * Vec2(square(normal.x()) - square(normal.y()), 2 * normal.x() * normal.y());
  }
  return unit(heading_of(doubled) / 2);
}

void PoseAligner::associate_all(const Pose2& T_map_sensor, std::span<const SensedSegment> segments,
                                std::span<const WallEstimate> walls, std::span<const int> candidates,
                                const AssociationGate& gate) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    wall_of_segment_[i] = associate(PlacedSegment(segments[i], T_map_sensor), walls, candidates, gate);
  }
}

Alignment PoseAligner::align(std::span<const SensedSegment> segments, std::span<const WallEstimate> walls,
                             std::span<const int> candidates, const PosePrior& prior, double gate_m,
                             int iterations) {
  wall_of_segment_.assign(segments.size(), -1);
  Pose2 pose = prior.T_map_sensor;
  const double parallel_cosine = std::cos(kParallelSigmas * params_.oblique_sigma_rad);
  Vec2 most = Vec2::Zero();
  Alignment result;
  for (const SensedSegment& s : segments) result.seen_m += s.length_m;

  for (int round = 0; round < iterations; ++round) {
    if (round < kAssociationRounds) {
      associate_all(pose, segments, walls, candidates, gate_in_round(round, gate_m, prior.information));
      most = normal_of_most(segments, walls);
    }
    Vec3 gradient = prior.information * change_between(prior.T_map_sensor, pose);
    Mat3 information = Mat3::Zero();
    result.matched_m = result.fitting_m = 0;
    constraints_.clear();
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (wall_of_segment_[i] < 0) continue;
      const auto index = static_cast<std::size_t>(wall_of_segment_[i]);
      const WallEstimate& wall = walls[index];
      const SensedSegment& seen = segments[i];
      const Vec2 lever(c * seen.centroid.x() - s * seen.centroid.y(),
                       s * seen.centroid.x() + c * seen.centroid.y());
      const double offset_m = wall.offset_of(lever + pose.position());
      const double turn_rad = wrap_angle(pose.theta + seen.heading_rad - wall.heading_rad);

      double offset_variance =
          square(seen.sigma_offset_m) + square(params_.wall_sigma_m) / std::max(1, wall.sightings);
      double heading_variance = square(seen.sigma_heading_rad);
      if (wall.is_oblique()) {
        offset_variance += square(params_.oblique_sigma_m);
        heading_variance += square(params_.oblique_sigma_rad);
      }
      const double trust = std::min(1.0, (wall.sightings + 0.5) / params_.sightings_for_full_weight);
      const double offset_fit = cauchy_weight(offset_m, params_.cauchy_m);
      const double offset_weight = trust / offset_variance * offset_fit;
      const double heading_weight = trust / heading_variance * cauchy_weight(turn_rad, params_.cauchy_rad);

      const Vec2 normal = normal_to_trust(wall, most, parallel_cosine);
      const Vec3 jacobian(normal.x(), normal.y(), normal.dot(left_normal(lever)));
      information += offset_weight * jacobian * jacobian.transpose();
      gradient += offset_weight * offset_m * jacobian;
      constraints_.push_back({index, normal, offset_weight});
      information(2, 2) += heading_weight;
      gradient(2) += heading_weight * turn_rad;
      result.matched_m += seen.length_m;
      result.fitting_m += seen.length_m * offset_fit;
    }
    const Vec3 step = -(information + prior.information).ldlt().solve(gradient);
    pose = moved_by(pose, step);
    result.wall_information = information;
    if (round + 1 >= kAssociationRounds && step.norm() < kSettledStep) break;
  }
  result.T_map_sensor = pose;
  return result;
}

}  // namespace aisle
