#include "landmarks/landmark_adjustment.hpp"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "landmarks/landmark_residuals.hpp"
#include "odometry_arc.hpp"

namespace aisle {
namespace {

constexpr double kCauchy = 2;         // standard deviations at which a sighting begins to count less
constexpr double kKeyframe_m = 0.05;  // poses closer than this to the previous one move with it
constexpr double kKeyframe_rad = 0.01;
constexpr double kLeastMotionSigma = 1e-4;    // of a motion [m, rad]
constexpr double kLeastKnownSigma_m = 0.002;  // of a landmark known from earlier runs
constexpr int kIterationsMax = 25;
constexpr double kLoopHuber = 3;

/// The poses that are unknowns, and the keyframe that each cycle belongs to.
struct Keyframes {
  std::vector<std::size_t> cycles;    ///< of each keyframe
  std::vector<std::size_t> of_cycle;  ///< keyframe at or before each cycle
};

Keyframes choose_keyframes(const std::vector<Pose2>& T_map_vehicle) {
  Keyframes keyframes;
  for (std::size_t i = 0; i < T_map_vehicle.size(); ++i) {
    const bool last = i + 1 == T_map_vehicle.size();
    bool far = keyframes.cycles.empty() || last;
    if (!far) {
      const Pose2 moved = between(T_map_vehicle[keyframes.cycles.back()], T_map_vehicle[i]);
      far = moved.position().norm() > kKeyframe_m || std::abs(moved.theta) > kKeyframe_rad;
    }
    if (far) keyframes.cycles.push_back(i);
    keyframes.of_cycle.push_back(keyframes.cycles.size() - 1);
  }
  return keyframes;
}

/// M with M^T M = covariance^-1.
template <class Matrix>
Matrix root_information(const Matrix& covariance) {
  return Matrix(covariance.inverse()).llt().matrixU();
}

OdometryError odometry_error(std::span<const LandmarkCycle> cycles, std::size_t from, std::size_t to,
                             const VehicleDescription& vehicle) {
  OdometryError error{.arcs = {}, .steady_sigmas = steady_odometry_sigmas(vehicle), .root_information = {}};
  UncertainPose2 moved;
  for (std::size_t i = from + 1; i <= to; ++i) {
    const UncertainArc read = uncertain_arc(vehicle, cycles[i].odometry);
    if (read.arc.length_m == 0 && read.arc.turn_rad == 0) continue;
    error.arcs.push_back(read.arc);
    const Mat32 by_arc = end_pose_jacobian(read.arc);
    moved = moved * UncertainPose2{end_pose(read.arc), by_arc * read.covariance * by_arc.transpose()};
  }
  error.root_information =
      root_information(Mat3(moved.covariance + Mat3::Identity() * square(kLeastMotionSigma)));
  return error;
}

/// A symmetric matrix with its negative eigenvalues set to zero.
Mat2 positive_part(const Mat2& m) {
  const Eigen::SelfAdjointEigenSolver<Mat2> solver(m);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// How far sightings scatter beyond their own errors: the seen position of an occluding edge, or of one of
/// two lines of a door frame, depends on where it is seen from.
std::vector<Mat2> unexplained_spread(const RunEvidence& run, const std::vector<Pose2>& T_map_vehicle,
                                     const std::vector<double>& tilts,
                                     const std::vector<Landmark>& landmarks) {
  std::vector<Mat2> spread(landmarks.size(), Mat2::Zero());
  std::vector<int> count(landmarks.size(), 0);
  for (const LandmarkObservation& seen : run.observations) {
    const LandmarkSighting& sighting = run.cycles[seen.cycle].sightings[seen.sighting];
    const Pose2& T = T_map_vehicle[seen.cycle];
    const Vec2 off =
        T * Vec2(sighting.p_vehicle - sighting.by_tilt * tilts[seen.cycle]) - landmarks[seen.landmark].p_map;
    const Mat2 R_map_vehicle = rotation(T.theta);
    const Mat2 own = sighting.own_covariance();
    spread[seen.landmark] += off * off.transpose() - R_map_vehicle * own * R_map_vehicle.transpose();
    ++count[seen.landmark];
  }
  for (std::size_t i = 0; i < spread.size(); ++i)
    spread[i] = positive_part(spread[i] / std::max(count[i], 1));
  return spread;
}

/// The least-squares problem of a run. Unknowns: its keyframes, each image's tilt, the walls' directions, the
/// systematic odometry errors, and the landmarks.
class Adjustment {
 public:
  Adjustment(const RunEvidence& run, std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks)
      : run_(run),
        T_map_vehicle_(T_map_vehicle),
        landmarks_(landmarks),
        keyframes_(choose_keyframes(T_map_vehicle)),
        tilts_(run.cycles.size(), 0.0),
        information_(landmarks.size(), Mat2::Zero()) {
    for (const std::size_t cycle : keyframes_.cycles) {
      const Pose2& T = T_map_vehicle[cycle];
      keys_.push_back({T.x, T.y, T.theta});
    }
    for (std::size_t i = 0; i < run.cycles.size(); ++i)
      T_key_cycle_.push_back(
          between(T_map_vehicle[keyframes_.cycles[keyframes_.of_cycle[i]]], T_map_vehicle[i]));
    for (const WallObservation& seen : run.walls) {
      while (walls_rad_.size() <= static_cast<std::size_t>(seen.walls))
        walls_rad_.push_back(T_map_vehicle[seen.cycle].theta - seen.against_walls.heading_rad);
    }
  }

  void add_odometry(const VehicleDescription& vehicle) {
    const auto& cycles = keyframes_.cycles;
    for (std::size_t k = 1; k < keys_.size(); ++k) {
      add<OdometryError, 3, 3, 3, 3>(odometry_error(run_.cycles, cycles[k - 1], cycles[k], vehicle), nullptr,
                                     keys_[k - 1].data(), keys_[k].data(), steady_.data());
    }
    if (keys_.size() < 2) return;
    if (run_.known.empty()) problem_.SetParameterBlockConstant(keys_.front().data());
    add<NearZero<3>, 3, 3>({}, nullptr, steady_.data());
  }

  void add_loops() {
    for (const LandmarkLoop& loop : run_.loops) {
      const Pose2 T_a_b =
          T_key_cycle_[loop.earlier_cycle] * loop.T_earlier_later * T_key_cycle_[loop.later_cycle].inverse();
      add<LoopError, 3, 3, 3>({T_a_b}, new ceres::HuberLoss(kLoopHuber), key_of(loop.earlier_cycle),
                              key_of(loop.later_cycle));
    }
  }

  void add_known() {
    for (std::size_t i = 0; i < run_.known.size(); ++i) {
      const Mat2 covariance = run_.known[i].covariance + square(kLeastKnownSigma_m) * Mat2::Identity();
      add<KnownError, 2, 2>({run_.known[i].p_map, root_information(covariance)},
                            new ceres::CauchyLoss(kCauchy), landmarks_[i].p_map.data());
      information_[i] = covariance.inverse();
    }
  }

  void add_sightings() {
    for (const LandmarkObservation& seen : run_.observations) {
      const LandmarkSighting& sighting = run_.cycles[seen.cycle].sightings[seen.sighting];
      add<SightingError, 2, 3, 1, 2>(
          {T_key_cycle_[seen.cycle], sighting, root_information(sighting.own_covariance())},
          new ceres::CauchyLoss(kCauchy), key_of(seen.cycle), &tilts_[seen.cycle],
          landmarks_[seen.landmark].p_map.data());
      const Mat2 R_map_vehicle = rotation(T_map_vehicle_[seen.cycle].theta);
      information_[seen.landmark] +=
          R_map_vehicle * sighting.covariance.inverse() * R_map_vehicle.transpose();
    }
    for (double& tilt : tilts_) {
      if (problem_.HasParameterBlock(&tilt)) add<NearZero<1>, 1, 1>({}, nullptr, &tilt);
    }
  }

  void add_walls() {
    for (const WallObservation& seen : run_.walls) {
      add<WallError, 1, 3, 1>({T_key_cycle_[seen.cycle].theta, seen.against_walls},
                              new ceres::CauchyLoss(kCauchy), key_of(seen.cycle),
                              &walls_rad_[static_cast<std::size_t>(seen.walls)]);
    }
  }

  /// Moves poses and landmarks to the least-squares solution.
  void solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = kIterationsMax;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    for (std::size_t i = 0; i < T_map_vehicle_.size(); ++i) {
      const double* key = key_of(i);
      T_map_vehicle_[i] = Pose2{key[0], key[1], key[2]} * T_key_cycle_[i];
    }
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      if (information_[i].determinant() > 0) landmarks_[i].covariance = information_[i].inverse();
    }
  }

  const std::vector<double>& tilts() const { return tilts_; }

 private:
  template <class Error, int... kSizes, class... Unknowns>
  void add(const Error& error, ceres::LossFunction* loss, Unknowns*... unknowns) {
    problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<Error, kSizes...>(new Error(error)), loss,
                              unknowns...);
  }

  double* key_of(std::size_t cycle) { return keys_[keyframes_.of_cycle[cycle]].data(); }

  const RunEvidence& run_;
  std::vector<Pose2>& T_map_vehicle_;
  std::vector<Landmark>& landmarks_;
  Keyframes keyframes_;
  std::vector<std::array<double, 3>> keys_;  ///< the keyframes' poses
  std::vector<Pose2> T_key_cycle_;           ///< of each cycle relative to its keyframe
  std::vector<double> tilts_;                ///< of each cycle's image, in standard deviations
  std::vector<double> walls_rad_;
  std::array<double, 3> steady_{};  ///< errors of the odometry, in standard deviations
  std::vector<Mat2> information_;   ///< of each landmark
  ceres::Problem problem_;
};

}  // namespace

std::vector<Mat2> adjust_landmarks(const RunEvidence& run, const VehicleDescription& vehicle,
                                   std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks) {
  Adjustment adjustment(run, T_map_vehicle, landmarks);
  adjustment.add_odometry(vehicle);
  adjustment.add_loops();
  adjustment.add_known();
  adjustment.add_sightings();
  adjustment.add_walls();
  adjustment.solve();
  return unexplained_spread(run, T_map_vehicle, adjustment.tilts(), landmarks);
}

}  // namespace aisle
