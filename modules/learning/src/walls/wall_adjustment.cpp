#include "walls/wall_adjustment.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"
#include "walls/wall_residuals.hpp"

namespace aisle {
namespace {

constexpr double kOrthogonalMin_m = 0.1;  // shorter segments are not used
constexpr double kObliqueMin_m = 0.4;
constexpr double kWallMax_m = 12;  // walls are not merged beyond this length: floors bend
constexpr double kIndexMargin_m = 0.4;
constexpr double kAssociateHeading_rad = 6 * kDegree;
constexpr double kAssociateOverlap_m = 0.1;
constexpr int kSightingsMin = 3;
constexpr double kFirstGate_m = 0.15;
constexpr int kIterations = 3;
constexpr double kWallsSettled = 1e-3;  // [m, rad]
constexpr double kWallSigma_m = 0.01;
constexpr double kWallSigma_rad = 0.5 * kDegree;
constexpr double kAdjustmentCauchy_m = 0.04;
constexpr double kCauchy_rad = 1.5 * kDegree;
constexpr double kMotionCauchy2 = 9;
constexpr double kRelocatedVariance = 0.01;
constexpr double kFixed = 1e8;  // holds the first keyframe's position

}  // namespace

struct WallAdjustment::Solver {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd gradient;

  /// Adds to the lower triangle only.
  void add(std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(std::max(row, column)), static_cast<int>(std::min(row, column)),
                         value);
  }
};

void WallAdjustment::SolverDeleter::operator()(Solver* solver) const {
  delete solver;
}

WallAdjustment::WallAdjustment(std::span<const Keyframe> keyframes, const ScanSegments& segments,
                               std::vector<Pose2> T_map_sensor, const MotionNoise& motion,
                               double odometry_factor, bool orthogonal)
    : keyframes_(keyframes),
      T_map_sensor_(std::move(T_map_sensor)),
      motion_(motion),
      odometry_factor_(odometry_factor),
      solver_(new Solver) {
  update_.weight_cap = 1e9;
  if (!orthogonal) {
    update_.axis_tolerance_rad = -1;
    oblique_sigma_m_ = oblique_sigma_rad_ = 0;
  }
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    for (const SensedSegment& s : segments.of_scan(keyframes[k].scan)) {
      const double heading_rad = wrap_angle(T_map_sensor_[k].theta + s.heading_rad);
      const bool oblique = s.curved || facing_of(heading_rad, update_.axis_tolerance_rad) == Facing::kOblique;
      if (s.length_m >= (oblique ? kObliqueMin_m : kOrthogonalMin_m)) observations_.push_back({k, &s});
    }
  }
  std::stable_sort(observations_.begin(), observations_.end(),
                   [](const Observation& a, const Observation& b) {
                     return std::floor(std::min(a.segment->length_m, 4.0)) >
                            std::floor(std::min(b.segment->length_m, 4.0));
                   });
}

void WallAdjustment::run(int rounds) {
  for (int round = 0; round < rounds; ++round) {
    associate_all(kFirstGate_m * (round == 0 ? 1.0 : round == 1 ? 0.75 : 0.5));
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      if (solve(iteration == 0) < kWallsSettled) break;
    }
  }
}

void WallAdjustment::find_near(const PlacedSegment& placed, double margin_m) {
  index_.query(placed.segment.start, placed.segment.end, margin_m, near_);
}

void WallAdjustment::associate_all(double gate_m) {
  update_.gate_m = gate_m;
  walls_.clear();
  index_.clear();
  for (const Observation& o : observations_) {
    const PlacedSegment placed(*o.segment, T_map_sensor_[o.keyframe]);
    find_near(placed, kIndexMargin_m);
    std::erase_if(near_, [&](int id) {
      const WallEstimate& wall = walls_[static_cast<std::size_t>(id)];
      const double united_m = wall.extent.united(wall.span_of(placed.segment)).length();
      return united_m > std::max(kWallMax_m, wall.length_m() + 0.05);
    });
    const int wall = absorb(placed, 0, update_, walls_, near_);
    index_.add(walls_[static_cast<std::size_t>(wall)].segment(), wall);
  }
  std::vector<int> sightings(walls_.size(), 0);
  for (Observation& o : observations_) {  // again, now that all walls exist
    const PlacedSegment placed(*o.segment, T_map_sensor_[o.keyframe]);
    find_near(placed, kIndexMargin_m);
    o.wall = associate(placed, walls_, near_, {gate_m, kAssociateHeading_rad, kAssociateOverlap_m});
    if (o.wall >= 0) ++sightings[static_cast<std::size_t>(o.wall)];
  }
  unknown_of_wall_.assign(walls_.size(), -1);
  unknowns_ = 3 * keyframes_.size();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].sightings = sightings[w];
    if (sightings[w] < kSightingsMin) continue;
    unknown_of_wall_[w] = static_cast<int>(unknowns_);
    unknowns_ += walls_[w].is_oblique() ? 2 : 1;
  }
}

/// One Gauss-Newton step; returns the largest change of a keyframe.
double WallAdjustment::solve(bool first_of_round) {
  solver_->entries.clear();
  solver_->gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_));
  add_motions();
  add_observations();
  solver_->add(0, 0, kFixed);
  solver_->add(1, 1, kFixed);
  for (std::size_t i = 0; i < unknowns_; ++i) solver_->add(i, i, i < 3 * keyframes_.size() ? 1e-3 : 1.0);
  Eigen::SparseMatrix<double> normal(static_cast<Eigen::Index>(unknowns_),
                                     static_cast<Eigen::Index>(unknowns_));
  normal.setFromTriplets(solver_->entries.begin(), solver_->entries.end());
  if (first_of_round) solver_->factor.analyzePattern(normal);
  solver_->factor.factorize(normal);
  const Eigen::VectorXd step = -solver_->factor.solve(solver_->gradient);
  apply(step);
  return step.head(static_cast<Eigen::Index>(3 * keyframes_.size())).lpNorm<Eigen::Infinity>();
}

/// Motions between keyframes stay as tracked.
void WallAdjustment::add_motions() {
  Eigen::VectorXd& gradient = solver_->gradient;
  for (std::size_t k = 0; k + 1 < keyframes_.size(); ++k) {
    const Pose2 tracked = relative_pose(keyframes_[k], keyframes_[k + 1], odometry_factor_);
    const auto [off, by_from, by_to] = MotionResidual(T_map_sensor_[k], T_map_sensor_[k + 1], tracked);
    Mat3 covariance = motion_.covariance(tracked);
    if (keyframes_[k + 1].relocated) covariance.diagonal().array() += kRelocatedVariance;
    Mat3 information = covariance.inverse();
    information *= 1 / (1 + off.dot(information * off) / kMotionCauchy2);
    const Mat3 from_from = by_from.transpose() * information * by_from;
    const Mat3 to_to = by_to.transpose() * information * by_to;
    const Mat3 to_from = by_to.transpose() * information * by_from;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        if (i >= j) {
          solver_->add(3 * k + i, 3 * k + j, from_from(row, column));
          solver_->add(3 * k + 3 + i, 3 * k + 3 + j, to_to(row, column));
        }
        solver_->add(3 * k + 3 + i, 3 * k + j, to_from(row, column));
      }
    }
    gradient.segment<3>(static_cast<Eigen::Index>(3 * k)) += by_from.transpose() * information * off;
    gradient.segment<3>(static_cast<Eigen::Index>(3 * k + 3)) += by_to.transpose() * information * off;
  }
}

/// Segments lie on their walls.
void WallAdjustment::add_observations() {
  Eigen::VectorXd& gradient = solver_->gradient;
  for (const Observation& o : observations_) {
    if (o.wall < 0 || unknown_of_wall_[static_cast<std::size_t>(o.wall)] < 0) continue;
    const WallEstimate& wall = walls_[static_cast<std::size_t>(o.wall)];
    const auto [offset_m, turn_rad, jacobian] = SegmentResidual(*o.segment, T_map_sensor_[o.keyframe], wall);
    double offset_variance = square(o.segment->sigma_offset_m) + square(kWallSigma_m);
    double heading_variance = square(o.segment->sigma_heading_rad) + square(kWallSigma_rad);
    if (wall.is_oblique()) {
      offset_variance += square(oblique_sigma_m_);
      heading_variance += square(oblique_sigma_rad_);
    }
    const double offset_weight = 1 / offset_variance / (1 + square(offset_m / kAdjustmentCauchy_m));
    const double heading_weight = 1 / heading_variance / (1 + square(turn_rad / kCauchy_rad));

    const std::size_t keyframe = 3 * o.keyframe;
    const auto unknown = static_cast<std::size_t>(unknown_of_wall_[static_cast<std::size_t>(o.wall)]);
    const std::size_t at[5] = {keyframe, keyframe + 1, keyframe + 2, unknown, unknown + 1};
    const std::size_t count = wall.is_oblique() ? 5 : 4;
    for (std::size_t i = 0; i < count; ++i) {
      gradient(static_cast<Eigen::Index>(at[i])) += offset_weight * offset_m * jacobian[i];
      for (std::size_t j = 0; j <= i; ++j)
        solver_->add(at[i], at[j], offset_weight * jacobian[i] * jacobian[j]);
    }
    solver_->add(at[2], at[2], heading_weight);
    gradient(static_cast<Eigen::Index>(at[2])) += heading_weight * turn_rad;
    if (wall.is_oblique()) {
      solver_->add(at[4], at[4], heading_weight);
      solver_->add(at[4], at[2], -heading_weight);
      gradient(static_cast<Eigen::Index>(at[4])) -= heading_weight * turn_rad;
    }
  }
}

void WallAdjustment::apply(const Eigen::VectorXd& step) {
  for (std::size_t k = 0; k < keyframes_.size(); ++k) {
    const Vec3 moved = step.segment<3>(static_cast<Eigen::Index>(3 * k));
    Pose2& pose = T_map_sensor_[k];
    pose = {pose.x + moved(0), pose.y + moved(1), wrap_angle(pose.theta + moved(2))};
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (unknown_of_wall_[w] < 0) continue;
    walls_[w].anchor += walls_[w].normal * step(unknown_of_wall_[w]);
    if (walls_[w].is_oblique()) {
      walls_[w].set_heading(wrap_angle(walls_[w].heading_rad + step(unknown_of_wall_[w] + 1)));
    }
  }
}

std::vector<WallEstimate> WallAdjustment::walls() const {
  std::vector<WallEstimate> taking_part;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (unknown_of_wall_[w] >= 0) taking_part.push_back(walls_[w]);
  }
  return taking_part;
}

std::vector<WallSighting> WallAdjustment::sightings() const {
  std::vector<int> index(walls_.size(), -1);
  int next = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (unknown_of_wall_[w] >= 0) index[w] = next++;
  }
  std::vector<WallSighting> sightings;
  for (const Observation& o : observations_) {
    if (o.wall < 0 || index[static_cast<std::size_t>(o.wall)] < 0) continue;
    sightings.push_back({T_map_sensor_[o.keyframe] * o.segment->segment,
                         index[static_cast<std::size_t>(o.wall)], keyframes_[o.keyframe].path_m});
  }
  std::stable_sort(sightings.begin(), sightings.end(),
                   [](const WallSighting& a, const WallSighting& b) { return a.path_m < b.path_m; });
  return sightings;
}

}  // namespace aisle
