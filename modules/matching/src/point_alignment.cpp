#include "aisle/matching/point_alignment.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"

namespace aisle {
namespace {

constexpr double kSearchFar_m =
    100;  ///< what is seen beyond does not count in a search: its memory is bounded
constexpr double kThinned_m = 0.02;  // points nearer to one another add nothing
constexpr double kChord_m = 0.12;    // a normal is that of a chord at least this long ...
constexpr std::size_t kChordReach =
    10;  // ... between points at most this far apart in the order of the beams
constexpr double kChordMin_m = 0.03;
constexpr double kGapShare = 0.35;    // neighbours farther apart than this share of their range ...
constexpr double kGapFloor_m = 0.08;  // ... or this are on different surfaces ...
constexpr double kGapBeams = 3;       // ... and so are those with this many beams between them
constexpr double kAgreeing = 0.7;     // cosine between normals of one surface
constexpr double kOnSurface_m = 0.06;
constexpr double kPointSigma_m = 0.03;
constexpr double kCauchy_m = 0.05;
constexpr int kFitRounds = 12;
constexpr double kReachFirst_m = 0.3;
constexpr double kReachLast_m = 0.1;
constexpr double kStepDone = 1e-5;
constexpr double kSearchStep_m = 0.1;
constexpr double kSearchStep_rad = 2 * kDegree;
constexpr std::size_t kSearchPoints = 60;
constexpr std::size_t kCandidates = 4;
constexpr std::size_t kFitPoints = 200;

/// The cells beside a map's points around a place, for fast counting.
class NearCells {
 public:
  NearCells(const SurfaceMap& map, const Vec2& centre, double half_m)
      : corner_(centre - Vec2(half_m, half_m)),
        side_(static_cast<long>(std::ceil(2 * half_m / SurfaceMap::kNearCell_m)) + 1),
        is_near_(static_cast<std::size_t>(side_ * side_), 0) {
    map.for_each_near_cell([&](const Vec2& p_map) {
      if (const long cell = cell_at(p_map); cell >= 0) is_near_[static_cast<std::size_t>(cell)] = 1;
    });
  }

  std::size_t at(const Vec2& p_map) const {
    const long cell = cell_at(p_map);
    return cell < 0 ? 0 : is_near_[static_cast<std::size_t>(cell)];
  }

 private:
  long cell_at(const Vec2& p_map) const {
    const Vec2 cells = (p_map - corner_) / SurfaceMap::kNearCell_m;
    const long column = std::lround(cells.x()), row = std::lround(cells.y());
    const bool inside = cells.x() >= 0 && cells.y() >= 0 && column < side_ && row < side_;
    return inside ? row * side_ + column : -1;
  }

  Vec2 corner_;
  long side_;
  std::vector<std::uint8_t> is_near_;
};

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

/// The usual angle from a point to the next.
double beam_step_rad(std::span<const Vec2> points) {
  std::vector<double> steps_rad;
  for (std::size_t i = 1; i < points.size(); ++i)
    steps_rad.push_back(angle_between(points[i - 1], points[i]));
  return steps_rad.empty() ? 0 : median(std::move(steps_rad));
}

/// @param most_rad  the largest angle between neighbours
bool is_gap(const Vec2& a, const Vec2& b, double most_rad) {
  return (a - b).norm() > std::max(kGapFloor_m, kGapShare * std::min(a.norm(), b.norm())) ||
         angle_between(a, b) > most_rad;
}

std::size_t stride_for(std::size_t count, std::size_t wanted) {
  return std::max<std::size_t>(1, count / wanted);
}

}  // namespace

void surface_points(std::span<const Vec2> points, std::vector<SurfacePoint>& surface) {
  surface.clear();
  const std::size_t count = points.size();
  const double most_rad = kGapBeams * beam_step_rad(points);
  for (std::size_t i = 0; i < count; ++i) {
    if (!surface.empty() && (points[i] - surface.back().p).norm() < kThinned_m) continue;
    std::size_t first = i, last = i;
    while ((points[last] - points[first]).norm() < kChord_m && last - first < kChordReach) {
      const bool back =
          first > 0 && i - first < kChordReach && !is_gap(points[first], points[first - 1], most_rad);
      const bool ahead = last + 1 < count && !is_gap(points[last], points[last + 1], most_rad);
      if (!back && !ahead) break;
      if (back) --first;
      if (ahead) ++last;
    }
    const Vec2 chord = points[last] - points[first];
    const double length_m = chord.norm();
    if (length_m < kChordMin_m) continue;
    Vec2 normal = Vec2(-chord.y(), chord.x()) / length_m;
    if (normal.dot(points[i]) > 0) normal = -normal;
    surface.push_back({points[i], normal});
  }
}

std::int64_t SurfaceMap::key(long column, long row) {
  return (static_cast<std::int64_t>(column) << 32) ^ static_cast<std::uint32_t>(row);
}

void SurfaceMap::add(std::span<const SurfacePoint> surface, const Pose2& T_map_sensor) {
  ++scans_;
  for (const SurfacePoint& seen : surface) {
    const SurfacePoint point{T_map_sensor * seen.p, rotate(T_map_sensor.theta, seen.normal)};
    const SurfacePoint* known = nearest(point.p, point.normal, kThinned_m);
    const long column = std::lround(point.p.x() / kNearCell_m), row = std::lround(point.p.y() / kNearCell_m);
    for (long dx = -1; dx <= 1; ++dx) {
      for (long dy = -1; dy <= 1; ++dy) near_[key(column + dx, row + dy)] = scans_;
    }
    if (known != nullptr) continue;
    cells_[key(static_cast<long>(std::floor(point.p.x() / kCell_m)),
               static_cast<long>(std::floor(point.p.y() / kCell_m)))]
        .push_back({point, scans_});
  }
  if (scans_ % (kScansKept / 4) == 0) forget_old();
}

void SurfaceMap::forget_old() {
  const int oldest = scans_ - kScansKept;
  for (auto cell = cells_.begin(); cell != cells_.end();) {
    std::erase_if(cell->second, [&](const Kept& kept) { return kept.scan < oldest; });
    cell = cell->second.empty() ? cells_.erase(cell) : std::next(cell);
  }
  std::erase_if(near_, [&](const auto& cell) { return cell.second < oldest; });
}

const SurfacePoint* SurfaceMap::nearest(const Vec2& p_map, const Vec2& normal, double reach_m) const {
  const auto column_of = [](double at_m) { return static_cast<long>(std::floor(at_m / kCell_m)); };
  const SurfacePoint* best = nullptr;
  double best_m2 = reach_m * reach_m;
  for (long column = column_of(p_map.x() - reach_m); column <= column_of(p_map.x() + reach_m); ++column) {
    for (long row = column_of(p_map.y() - reach_m); row <= column_of(p_map.y() + reach_m); ++row) {
      const auto cell = cells_.find(key(column, row));
      if (cell == cells_.end()) continue;
      for (const Kept& kept : cell->second) {
        const double distance_m2 = (kept.point.p - p_map).squaredNorm();
        if (distance_m2 >= best_m2 || kept.point.normal.dot(normal) < kAgreeing) continue;
        best_m2 = distance_m2;
        best = &kept.point;
      }
    }
  }
  return best;
}

SurfaceFit fit_surface(std::span<const SurfacePoint> surface, const SurfaceMap& map, const Pose2& guess,
                       const Mat3& guess_information) {
  SurfaceFit fit{.T_map_sensor = guess};
  const std::size_t stride = stride_for(surface.size(), kFitPoints);
  for (int round = 0; round < kFitRounds; ++round) {
    const double reach_m = std::max(kReachLast_m, kReachFirst_m * std::pow(0.7, static_cast<double>(round)));
    const Mat2 turn_matrix = Eigen::Rotation2Dd(fit.T_map_sensor.theta).toRotationMatrix();
    const Vec2 t = fit.T_map_sensor.position();
    Mat3 information = Mat3::Zero();
    Vec3 pull = Vec3::Zero();
    std::size_t on_surface = 0, tried = 0;
    for (std::size_t i = 0; i < surface.size(); i += stride) {
      ++tried;
      const Vec2 arm = turn_matrix * surface[i].p;
      const Vec2 p_map = t + arm;
      const SurfacePoint* known = map.nearest(p_map, turn_matrix * surface[i].normal, reach_m);
      if (known == nullptr) continue;
      const double off_m = known->normal.dot(p_map - known->p);
      on_surface += std::abs(off_m) < kOnSurface_m;
      const double weight = 1 / (square(kPointSigma_m) * (1 + square(off_m / kCauchy_m)));
      const Vec3 slope(known->normal.x(), known->normal.y(), known->normal.dot(Vec2(-arm.y(), arm.x())));
      information += weight * slope * slope.transpose();
      pull -= weight * off_m * slope;
    }
    fit.information = information;
    fit.share = tried == 0 ? 0 : static_cast<double>(on_surface) / static_cast<double>(tried);
    pull += guess_information * change_between(fit.T_map_sensor, guess);
    const Mat3 whole = information + guess_information + Mat3::Identity();
    const Vec3 step = whole.ldlt().solve(pull);
    fit.T_map_sensor = moved_by(fit.T_map_sensor, step);
    if (step.norm() < kStepDone) break;
  }
  return fit;
}

SurfaceFit fit_surface_far(std::span<const SurfacePoint> surface, const SurfaceMap& map, const Pose2& guess,
                           const SearchReach& reach) {
  struct Candidate {
    std::size_t near = 0;
    Pose2 T_map_sensor;
  };
  double farthest_m = 0;
  for (const SurfacePoint& point : surface) farthest_m = std::max(farthest_m, point.p.norm());
  const NearCells near_cells(map, guess.position(), std::min(farthest_m, kSearchFar_m) + reach.position_m);
  std::vector<Candidate> best;
  std::vector<Vec2> turned;
  const std::size_t stride = stride_for(surface.size(), kSearchPoints);
  const int turns = static_cast<int>(std::ceil(reach.heading_rad / kSearchStep_rad));
  const int steps = static_cast<int>(std::ceil(reach.position_m / kSearchStep_m));
  for (int turn = -turns; turn <= turns; ++turn) {
    const double theta = wrap_angle(guess.theta + turn * kSearchStep_rad);
    const Mat2 turn_matrix = Eigen::Rotation2Dd(theta).toRotationMatrix();
    turned.clear();
    for (std::size_t i = 0; i < surface.size(); i += stride) turned.push_back(turn_matrix * surface[i].p);
    Candidate top;
    for (int ix = -steps; ix <= steps; ++ix) {
      for (int iy = -steps; iy <= steps; ++iy) {
        const Vec2 at = guess.position() + kSearchStep_m * Vec2(ix, iy);
        std::size_t near = 0;
        for (const Vec2& p : turned) near += near_cells.at(at + p);
        if (near > top.near) top = {near, {at.x(), at.y(), theta}};
      }
    }
    if (top.near > 0) best.push_back(top);
  }
  const auto kept = std::min(best.size(), kCandidates);
  std::partial_sort(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(kept), best.end(),
                    [](const Candidate& a, const Candidate& b) { return a.near > b.near; });
  best.resize(kept);
  SurfaceFit fit{.T_map_sensor = guess};
  for (const Candidate& candidate : best) {
    const SurfaceFit tried = fit_surface(surface, map, candidate.T_map_sensor, Mat3::Zero());
    if (tried.share > fit.share) fit = tried;
  }
  return fit;
}

}  // namespace aisle
