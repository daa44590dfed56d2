#include "landmarks/landmark_adjustment.hpp"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "odometry_arc.hpp"

namespace aisle {
namespace {

constexpr double kCauchy = 2;         // standard deviations at which a sighting begins to count less
constexpr double kKeyframe_m = 0.05;  // poses closer than this to the one before move with it
constexpr double kKeyframe_rad = 0.01;
constexpr double kLeastMotionSigma = 1e-4;    // of a motion [m, rad]
constexpr double kLeastKnownSigma_m = 0.002;  // of a landmark that earlier trips know
constexpr int kIterationsMax = 25;
constexpr double kLoopSigma_m = 0.03;  // of a loop
constexpr double kLoopSigma_rad = 0.5 * kDegree;
constexpr double kLoopHuber = 3;

/// The poses that are unknowns, and which cycle belongs to which.
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

/// How far b, seen from a, is off (x, y, theta).
template <class T>
std::array<T, 3> relative_pose_error(const T* a, const T* b, const T& x, const T& y, const T& theta) {
  const T c = cos(a[2]), s = sin(a[2]);
  const T turn = b[2] - a[2] - theta;
  return {c * (b[0] - a[0]) + s * (b[1] - a[1]) - x, -s * (b[0] - a[0]) + c * (b[1] - a[1]) - y,
          turn - 2 * kPi * floor((turn + kPi) / (2 * kPi))};
}

/// The odometry between two keyframes against their poses. Steady errors are unknowns in standard deviations.
struct OdometryError {
  std::vector<Arc> arcs;
  Vec3 steady_sigmas;
  Mat3 root_information;

  template <class T>
  bool operator()(const T* a, const T* b, const T* steady, T* residual) const {
    T x(0), y(0), theta(0);
    for (const Arc& arc : arcs) {
      const T length = arc.length_m * (1.0 + steady_sigmas[0] * steady[0]);
      const T turn =
          arc.turn_rad * (1.0 + steady_sigmas[1] * steady[1]) + arc.length_m * steady_sigmas[2] * steady[2];
      x += length * cos(theta + turn / 2.0);
      y += length * sin(theta + turn / 2.0);
      theta += turn;
    }
    const auto off = relative_pose_error(a, b, x, y, theta);
    for (int i = 0; i < 3; ++i) {
      residual[i] =
          root_information(i, 0) * off[0] + root_information(i, 1) * off[1] + root_information(i, 2) * off[2];
    }
    return true;
  }
};

/// A loop, between the keyframes of its two cycles.
struct LoopError {
  Pose2 T_a_b;

  template <class T>
  bool operator()(const T* a, const T* b, T* residual) const {
    const auto off = relative_pose_error(a, b, T(T_a_b.x), T(T_a_b.y), T(T_a_b.theta));
    residual[0] = off[0] / kLoopSigma_m;
    residual[1] = off[1] / kLoopSigma_m;
    residual[2] = off[2] / kLoopSigma_rad;
    return true;
  }
};

/// A landmark as seen from a keyframe whose picture's tilt is off by so many standard deviations.
struct SightingError {
  Pose2 T_key_vehicle;  ///< where the picture was taken, seen from its keyframe
  LandmarkSighting sighting;
  Mat2 root_information;

  template <class T>
  bool operator()(const T* key, const T* tilt, const T* landmark, T* residual) const {
    const T key_c = cos(key[2]), key_s = sin(key[2]);
    const T x = key[0] + key_c * T_key_vehicle.x - key_s * T_key_vehicle.y;
    const T y = key[1] + key_s * T_key_vehicle.x + key_c * T_key_vehicle.y;
    const T c = cos(key[2] + T_key_vehicle.theta), s = sin(key[2] + T_key_vehicle.theta);
    const T off_x = sighting.p_vehicle.x() - sighting.by_tilt.x() * tilt[0] -
                    (c * (landmark[0] - x) + s * (landmark[1] - y));
    const T off_y = sighting.p_vehicle.y() - sighting.by_tilt.y() * tilt[0] -
                    (-s * (landmark[0] - x) + c * (landmark[1] - y));
    residual[0] = root_information(0, 0) * off_x + root_information(0, 1) * off_y;
    residual[1] = root_information(1, 0) * off_x + root_information(1, 1) * off_y;
    return true;
  }
};

/// A landmark against its place as earlier trips know it.
struct KnownError {
  Vec2 p_map;
  Mat2 root_information;

  template <class T>
  bool operator()(const T* landmark, T* residual) const {
    const T off_x = landmark[0] - p_map.x(), off_y = landmark[1] - p_map.y();
    residual[0] = root_information(0, 0) * off_x + root_information(0, 1) * off_y;
    residual[1] = root_information(1, 0) * off_x + root_information(1, 1) * off_y;
    return true;
  }
};

/// The heading of a cycle, against walls whose direction is unknown.
struct WallError {
  double key_to_cycle_rad;
  HeadingMeasurement against_walls;

  template <class T>
  bool operator()(const T* key, const T* walls_rad, T* residual) const {
    const T off = key[2] + key_to_cycle_rad - walls_rad[0] - against_walls.heading_rad;
    residual[0] = (off - 2 * kPi * floor((off + kPi) / (2 * kPi))) / against_walls.sigma_rad;
    return true;
  }
};

/// Keeps unknowns in standard deviations near zero.
template <int kUnknowns>
struct NearZero {
  template <class T>
  bool operator()(const T* values, T* residual) const {
    std::copy_n(values, kUnknowns, residual);
    return true;
  }

  static ceres::CostFunction* cost() {
    return new ceres::AutoDiffCostFunction<NearZero, kUnknowns, kUnknowns>(new NearZero);
  }
};

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

/// What remains of a symmetric matrix above zero.
Mat2 positive_part(const Mat2& m) {
  const Eigen::SelfAdjointEigenSolver<Mat2> solver(m);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// What is seen behind an edge, or taken now for one line of a door's frame and now for another, wanders with
/// the place from where it is seen.
std::vector<Mat2> unexplained_spread(const TripEvidence& trip, const std::vector<Pose2>& T_map_vehicle,
                                     const std::vector<double>& tilts,
                                     const std::vector<Landmark>& landmarks) {
  std::vector<Mat2> spread(landmarks.size(), Mat2::Zero());
  std::vector<int> count(landmarks.size(), 0);
  for (const LandmarkObservation& seen : trip.observations) {
    const LandmarkSighting& sighting = trip.cycles[seen.cycle].sightings[seen.sighting];
    const Pose2& T = T_map_vehicle[seen.cycle];
    const Vec2 off =
        T * Vec2(sighting.p_vehicle - sighting.by_tilt * tilts[seen.cycle]) - landmarks[seen.landmark].p_map;
    const Mat2 R_map_vehicle = rotation(T.theta);
    const Mat2 own = sighting.covariance - sighting.by_tilt * sighting.by_tilt.transpose();
    spread[seen.landmark] += off * off.transpose() - R_map_vehicle * own * R_map_vehicle.transpose();
    ++count[seen.landmark];
  }
  for (std::size_t i = 0; i < spread.size(); ++i)
    spread[i] = positive_part(spread[i] / std::max(count[i], 1));
  return spread;
}

}  // namespace

std::vector<Mat2> adjust_landmarks(const TripEvidence& trip, const VehicleDescription& vehicle,
                                   std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks) {
  const std::span<const LandmarkCycle> cycles = trip.cycles;
  const Keyframes keyframes = choose_keyframes(T_map_vehicle);
  std::vector<std::array<double, 3>> keys;
  for (const std::size_t cycle : keyframes.cycles) {
    const Pose2& T = T_map_vehicle[cycle];
    keys.push_back({T.x, T.y, T.theta});
  }
  std::vector<Pose2> T_key_cycle(cycles.size());
  for (std::size_t i = 0; i < cycles.size(); ++i)
    T_key_cycle[i] = between(T_map_vehicle[keyframes.cycles[keyframes.of_cycle[i]]], T_map_vehicle[i]);
  std::vector<double> tilts(cycles.size(), 0.0);
  std::array<double, 3> steady{};

  ceres::Problem problem;
  for (std::size_t k = 1; k < keys.size(); ++k) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<OdometryError, 3, 3, 3, 3>(
            new OdometryError(odometry_error(cycles, keyframes.cycles[k - 1], keyframes.cycles[k], vehicle))),
        nullptr, keys[k - 1].data(), keys[k].data(), steady.data());
  }
  for (const LandmarkLoop& loop : trip.loops) {
    const std::size_t a = keyframes.of_cycle[loop.earlier_cycle], b = keyframes.of_cycle[loop.later_cycle];
    const Pose2 T_a_b =
        T_key_cycle[loop.earlier_cycle] * loop.T_earlier_later * T_key_cycle[loop.later_cycle].inverse();
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<LoopError, 3, 3, 3>(new LoopError{T_a_b}),
                             new ceres::HuberLoss(kLoopHuber), keys[a].data(), keys[b].data());
  }
  std::vector<Mat2> information(landmarks.size(), Mat2::Zero());
  for (std::size_t i = 0; i < trip.known.size(); ++i) {
    const Mat2 covariance = trip.known[i].covariance + square(kLeastKnownSigma_m) * Mat2::Identity();
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<KnownError, 2, 2>(
                                 new KnownError{trip.known[i].p_map, root_information(covariance)}),
                             new ceres::CauchyLoss(kCauchy), landmarks[i].p_map.data());
    information[i] = covariance.inverse();
  }
  for (const LandmarkObservation& seen : trip.observations) {
    const LandmarkSighting& sighting = cycles[seen.cycle].sightings[seen.sighting];
    const Mat2 own = sighting.covariance - sighting.by_tilt * sighting.by_tilt.transpose();
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<SightingError, 2, 3, 1, 2>(
                                 new SightingError{T_key_cycle[seen.cycle], sighting, root_information(own)}),
                             new ceres::CauchyLoss(kCauchy), keys[keyframes.of_cycle[seen.cycle]].data(),
                             &tilts[seen.cycle], landmarks[seen.landmark].p_map.data());
    const Mat2 R_map_vehicle = rotation(T_map_vehicle[seen.cycle].theta);
    information[seen.landmark] += R_map_vehicle * sighting.covariance.inverse() * R_map_vehicle.transpose();
  }
  std::vector<double> walls_rad;
  for (const WallObservation& seen : trip.walls) {
    while (walls_rad.size() <= static_cast<std::size_t>(seen.walls))
      walls_rad.push_back(T_map_vehicle[seen.cycle].theta - seen.against_walls.heading_rad);
  }
  for (const WallObservation& seen : trip.walls) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<WallError, 1, 3, 1>(
                                 new WallError{T_key_cycle[seen.cycle].theta, seen.against_walls}),
                             new ceres::CauchyLoss(kCauchy), keys[keyframes.of_cycle[seen.cycle]].data(),
                             &walls_rad[static_cast<std::size_t>(seen.walls)]);
  }
  for (double& tilt : tilts) {
    if (problem.HasParameterBlock(&tilt)) problem.AddResidualBlock(NearZero<1>::cost(), nullptr, &tilt);
  }
  if (keys.size() > 1) {
    if (trip.known.empty()) problem.SetParameterBlockConstant(keys.front().data());
    problem.AddResidualBlock(NearZero<3>::cost(), nullptr, steady.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = kIterationsMax;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const std::array<double, 3>& key = keys[keyframes.of_cycle[i]];
    T_map_vehicle[i] = Pose2{key[0], key[1], key[2]} * T_key_cycle[i];
  }
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (information[i].determinant() > 0) landmarks[i].covariance = information[i].inverse();
  }
  return unexplained_spread(trip, T_map_vehicle, tilts, landmarks);
}

}  // namespace aisle
