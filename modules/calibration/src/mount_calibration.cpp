#include "aisle/calibration/mount_calibration.hpp"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mount_start.hpp"

namespace aisle {
namespace {

using Values = Eigen::Matrix<double, 6, 1>;  ///< x, y, z, tilt, pan, roll

CameraMount to_mount(const double* v) {
  return {{v[0], v[1], v[2]}, v[3], v[4], v[5]};
}

Values to_values(const CameraMount& m) {
  Values values;
  values << m.p_vehicle_camera, m.tilt_rad, m.pan_rad, m.roll_rad;
  return values;
}

/// How far from its mark a pixel is, in standard deviations.
struct MarkResidual {
  const FloorMark* mark;
  const CameraModel* lens;
  double pixel_px;

  bool operator()(const double* values, double* residual) const {
    const Vec3 p_vehicle{mark->p_vehicle.x(), mark->p_vehicle.y(), 0};
    const auto expected = lens->project(to_mount(values).to_camera(p_vehicle));
    if (!expected) return false;
    Eigen::Map<Vec2>{residual} = (mark->pixel_px - *expected) / pixel_px;
    return true;
  }
};

using MarkCost = ceres::NumericDiffCostFunction<MarkResidual, ceres::CENTRAL, 2, 6>;

struct Refined {
  Values values;
  double cost = std::numeric_limits<double>::infinity();
};

Refined refined(std::span<const FloorMark> marks, const CameraModel& lens,
                const MountCalibrationParams& params, const CameraMount& start) {
  ceres::Problem problem;
  Refined result{to_values(start)};
  for (const FloorMark& mark : marks) {
    if (!MarkResidual{&mark, &lens, params.pixel_px}(result.values.data(), Vec2().data())) continue;
    problem.AddResidualBlock(new MarkCost(new MarkResidual{&mark, &lens, params.pixel_px}),
                             new ceres::CauchyLoss(3), result.values.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.function_tolerance = options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const bool is_above_the_floor = result.values.allFinite() && result.values[2] > 0;
  if (summary.IsSolutionUsable() && is_above_the_floor) result.cost = summary.final_cost;
  return result;
}

/// Residuals, and what fits: within four standard deviations, or within four times the usual residual where
/// the pixels are worse than expected.
void add_residuals(std::span<const FloorMark> marks, const CameraModel& lens,
                   const MountCalibrationParams& params, const Values& values, MountCalibration& result) {
  constexpr double kUnseen = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> distances;
  for (const FloorMark& mark : marks) {
    Vec2 residual;
    const bool is_seen = MarkResidual{&mark, &lens, 1}(values.data(), residual.data());
    result.residuals_px.push_back(is_seen ? residual : Vec2(kUnseen, kUnseen));
    distances.push_back(is_seen ? residual.norm() : std::numeric_limits<double>::infinity());
  }
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const double limit = 4 * std::max(params.pixel_px, sorted[sorted.size() / 2]);
  for (const double distance : distances) result.fits.push_back(distance <= limit);
}

/// Standard deviations from the residuals' slopes at the solution. The pixels' own deviation is estimated
/// together with the expectation, which counts as much as four more coordinates.
bool add_deviations(std::span<const FloorMark> marks, const CameraModel& lens,
                    const MountCalibrationParams& params, const Values& values, MountCalibration& result) {
  constexpr double kExpectationWeight = 4;
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!result.fits[i]) continue;
    const MarkCost cost(new MarkResidual{&marks[i], &lens, 1});
    Eigen::Matrix<double, 2, 6, Eigen::RowMajor> slopes;
    Vec2 residual;
    const double* const at = values.data();
    double* const jacobian = slopes.data();
    if (!cost.Evaluate(&at, residual.data(), const_cast<double**>(&jacobian))) return false;  // NOLINT
    information += slopes.transpose() * slopes;
    squares += residual.squaredNorm();
    count += 2;
  }
  if (count <= 6) return false;
  const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> inverse(information);
  if (!inverse.isInvertible()) return false;
  const double variance_px2 =
      (squares + kExpectationWeight * params.pixel_px * params.pixel_px) / (count - 6 + kExpectationWeight);
  const Values deviations = (variance_px2 * inverse.inverse().diagonal()).cwiseSqrt();
  result.deviations = to_mount(deviations.data());
  result.rms_px = std::sqrt(2 * squares / count);
  return deviations.allFinite();
}

}  // namespace

bool are_on_one_line(std::span<const FloorMark> marks) {
  Vec2 middle = Vec2::Zero();
  for (const FloorMark& mark : marks) middle += mark.p_vehicle / static_cast<double>(marks.size());
  Mat2 scatter = Mat2::Zero();
  for (const FloorMark& mark : marks) {
    scatter += (mark.p_vehicle - middle) * (mark.p_vehicle - middle).transpose();
  }
  const Vec2 extents = Eigen::SelfAdjointEigenSolver<Mat2>(scatter).eigenvalues();
  constexpr double kNarrow = 0.01;
  return extents[0] <= kNarrow * kNarrow * extents[1];
}

std::optional<MountCalibration> calibrate_mount(std::span<const FloorMark> marks, const CameraModel& lens,
                                                const MountCalibrationParams& params) {
  if (marks.size() < kFloorMarksMin) {
    throw std::invalid_argument("calibrate_mount: at least 4 marks are needed");
  }
  if (are_on_one_line(marks)) return std::nullopt;
  std::vector<Refined> solutions;
  for (const CameraMount& start : mount_starts(marks, lens)) {
    solutions.push_back(refined(marks, lens, params, start));
  }
  std::sort(solutions.begin(), solutions.end(),
            [](const Refined& a, const Refined& b) { return a.cost < b.cost; });
  if (solutions.empty() || !std::isfinite(solutions[0].cost)) return std::nullopt;

  const Values best = solutions[0].values;
  MountCalibration result{to_mount(best.data())};
  add_residuals(marks, lens, params, best, result);
  if (!add_deviations(marks, lens, params, best, result)) return std::nullopt;
  // Costs are half sums of squares in standard deviations: 4 is an odds of e^-4.
  result.is_ambiguous = solutions.size() > 1 && solutions[1].cost < solutions[0].cost + 4 &&
                        (solutions[1].values - best).norm() > 1e-3;
  result.mount = mount_of(result.mount.R_vehicle_camera(), result.mount.p_vehicle_camera);
  result.verdict = judge(result);
  return result;
}

}  // namespace aisle
