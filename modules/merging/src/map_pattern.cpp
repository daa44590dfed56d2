#include "aisle/merging/map_pattern.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kInFront_m = 0.05;  // the two faces of a thin wall are told apart from in front of them
constexpr double kSameFacing = 0.7;  // cosine
constexpr double kPastEnd_m = 0.05;  // two maps' ends of one wall differ by this
constexpr double kDeniedWeight = 2;  // walls do not vanish

struct OneSide {
  double common_m = 0, denied_m = 0, denied_run_m = 0;
  Mat2 spread = Mat2::Zero();
};

/// What one map says of the walls of the other. @param T_map_other  the other's frame in this map
OneSide opinions_of(const MapPattern& map, const MapPattern& other, const Pose2& T_map_other) {
  OneSide side;
  const Mat2 turn = rotation(T_map_other.theta);
  double run_m = 0;
  for (const WallSample& sample : other.samples()) {
    const Vec2 normal = turn * sample.normal;
    const MapOpinion opinion = map.opinion_of(T_map_other.position() + turn * sample.p_map, normal);
    if (sample.begins_wall || opinion != MapOpinion::kDenied) run_m = 0;
    if (opinion == MapOpinion::kDenied) {
      side.denied_m += sample.length_m;
      side.denied_run_m = std::max(side.denied_run_m, run_m += sample.length_m);
    }
    if (opinion != MapOpinion::kConfirmed) continue;
    side.common_m += sample.length_m;
    side.spread += sample.length_m * normal * normal.transpose();
  }
  return side;
}

/// Whether the place is on the surface, as far as two maps of it agree, and not in the opening at its end.
bool is_on(const Surface& surface, const Vec2& p_map) {
  if (surface.segment.distance(p_map) > MapPattern::kSame_m) return false;
  if (!surface.is_wall()) return true;
  const Vec2 wall = surface.segment.end - surface.segment.start;
  const double along_m = wall.normalized().dot(p_map - surface.segment.start);
  return along_m >= -kPastEnd_m && along_m <= wall.norm() + kPastEnd_m;
}

}  // namespace

MapPattern::MapPattern(const Building& building) : field_(building) {
  for (const Wall& wall : building.walls.walls) {
    const Vec2 along = wall.segment.end - wall.segment.start;
    const double length_m = along.norm();
    if (!(length_m > 0)) continue;
    wall_m_ += length_m;
    const Vec2 normal = left_normal(along / length_m);
    const int pieces = std::max(1, static_cast<int>(std::lround(length_m / kSample_m)));
    for (int i = 0; i < pieces; ++i)
      samples_.push_back(
          {wall.segment.start + along * ((i + 0.5) / pieces), normal, length_m / pieces, i == 0});
  }
}

const Surface* MapPattern::facing_wall(const Vec2& p_map, const Vec2& normal) const {
  const Surface* const surface = field_.nearest(p_map + kInFront_m * normal);
  const bool is_facing =
      surface != nullptr && surface->is_wall() && surface->normal.dot(normal) > kSameFacing;
  return is_facing ? surface : nullptr;
}

const Surface* MapPattern::same_wall(const Vec2& p_map, const Vec2& normal) const {
  const Surface* const surface = facing_wall(p_map, normal);
  return surface != nullptr && is_on(*surface, p_map) ? surface : nullptr;
}

MapOpinion MapPattern::opinion_of(const Vec2& p_map, const Vec2& normal, double beyond_m) const {
  const Surface* const surface = field_.nearest(p_map + kInFront_m * normal);
  const bool may_be_it =
      surface != nullptr && (!surface->is_wall() || surface->normal.dot(normal) > kSameFacing);
  if (may_be_it && is_on(*surface, p_map)) return MapOpinion::kConfirmed;
  const bool is_free = field_.can_stand(p_map) && field_.distance_m(p_map) > beyond_m;
  return is_free ? MapOpinion::kDenied : MapOpinion::kSilent;
}

double MapOverlap::fixing_m() const {
  return Eigen::SelfAdjointEigenSolver<Mat2>(spread).eigenvalues().minCoeff();
}

double MapOverlap::score_m() const {
  return common_m - kDeniedWeight * denied_m;
}

MapOverlap overlap_of(const MapPattern& fixed, const MapPattern& moved, const Pose2& T_fixed_moved) {
  const OneSide by_fixed = opinions_of(fixed, moved, T_fixed_moved);
  const OneSide by_moved = opinions_of(moved, fixed, T_fixed_moved.inverse());
  return {.common_m = (by_fixed.common_m + by_moved.common_m) / 2,
          .denied_m = by_fixed.denied_m + by_moved.denied_m,
          .denied_run_m = std::max(by_fixed.denied_run_m, by_moved.denied_run_m),
          .spread = by_fixed.spread};
}

}  // namespace aisle
