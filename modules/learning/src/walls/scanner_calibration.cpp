#include "aisle/learning/walls/scanner_calibration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/median.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr std::size_t kScansMin = 40;
constexpr std::size_t kScansMax = 1200;
constexpr double kEnoughTurn_rad = 540 * kDegree;
constexpr double kEnoughPath_m = 10;
constexpr double kCounted_m =
    0.1;  // motion counts in steps of this: noise adds nothing to a laser that stands
constexpr double kCounted_rad = 3 * kDegree;
constexpr double kWindow_s = 0.5;       // turns are compared over this long: single steps are mostly noise
constexpr double kCoarseStep_s = 0.05;  // between the delays that are tried first
constexpr double kFineStep_s = 0.01;
constexpr double kPieceMin_m = 0.3;
constexpr double kPieceMin_rad = 15 * kDegree;
constexpr double kTrackedInformation = 1 / (0.01 * 0.01);
constexpr double kSure = 3;  // standard deviations
constexpr double kOffsetMin_m = 0.02;
constexpr double kHeadingMin_rad = 1 * kDegree;
constexpr std::size_t kPiecesMin = 20;
constexpr int kRobustRounds = 5;
constexpr double kOdometryShare = 0.05;  // of a piece's motion: what the odometry may be off
constexpr double kPairSigma_m = 0.01;

double turn_between(const OdometryTrack& track, std::size_t known, double from_s, double to_s) {
  return wrap_angle(track.at(to_s, known).theta - track.at(from_s, known).theta);
}

/// The turn by the scans over windows of kWindow_s.
struct Turn {
  double from_s, to_s, turn_rad;
};

std::vector<Turn> turns_of(const SampledMotion& scans) {
  std::vector<Turn> turns;
  for (std::size_t i = 0, j = 1; j < scans.times_s.size(); ++j) {
    while (i + 1 < j && scans.times_s[j] - scans.times_s[i + 1] >= kWindow_s) ++i;
    turns.push_back({scans.times_s[i], scans.times_s[j],
                     wrap_angle(scans.T_first_laser[j].theta - scans.T_first_laser[i].theta)});
  }
  return turns;
}

TurnAgreement agreement_at(const std::vector<Turn>& turns, const OdometryTrack& track, std::size_t known,
                           double delay_s) {
  double both = 0, by_scans = 0, by_odometry = 0;
  for (const Turn& turn : turns) {
    const double counted = turn_between(track, known, turn.from_s - delay_s, turn.to_s - delay_s);
    both += turn.turn_rad * counted;
    by_scans += square(turn.turn_rad);
    by_odometry += square(counted);
  }
  if (by_scans == 0 || by_odometry == 0) return {0, 0, delay_s};
  return {both / std::sqrt(by_scans * by_odometry), both / by_odometry, delay_s};
}

}  // namespace

double SampledMotion::turned_rad() const {
  double turned = 0, counted_rad = 0;
  for (const Pose2& pose : T_first_laser) {
    const double step_rad = wrap_angle(pose.theta - counted_rad);
    if (std::abs(step_rad) < kCounted_rad) continue;
    turned += std::abs(step_rad);
    counted_rad = pose.theta;
  }
  return turned;
}

double SampledMotion::moved_m() const {
  double moved_m = 0;
  Vec2 counted = Vec2::Zero();
  for (const Pose2& pose : T_first_laser) {
    const double step_m = (pose.position() - counted).norm();
    if (step_m < kCounted_m) continue;
    moved_m += step_m;
    counted = pose.position();
  }
  return moved_m;
}

SampledMotion sample_motion(const LaserLog& log, std::optional<ScanBeams> beams) {
  SampledMotion sample;
  ScanOdometry scans;
  std::vector<Vec2> points;
  std::vector<double> shares;
  double turned_rad = 0, moved_m = 0;
  for (const LaserScan& scan : log.scans) {
    if (scan.laser != 0) continue;
    LaserScanner laser = log.laser_of(scan);
    if (beams) {
      laser.first_angle_rad = beams->first_angle_rad;
      laser.angle_step_rad = beams->angle_step_rad;
    }
    points_of(laser, scan.ranges_m, points);
    const ScanMotion motion = scans.step(points, scan.time_s);
    sample.times_s.push_back(scan.time_s);
    sample.T_first_laser.push_back(scans.T_first_laser());
    sample.information.push_back(motion.information);
    shares.push_back(motion.share);
    turned_rad += std::abs(motion.T_last_now.mean.theta);
    moved_m += motion.T_last_now.mean.position().norm();
    const std::size_t count = sample.times_s.size();
    if (count >= kScansMax || (count >= kScansMin && turned_rad > kEnoughTurn_rad && moved_m > kEnoughPath_m))
      break;
  }
  if (!shares.empty()) sample.median_share = median(std::move(shares));
  return sample;
}

TurnAgreement compare_turns(const SampledMotion& scans, std::span<const OdometrySample> odometry,
                            double delay_max_s) {
  const OdometryTrack track(odometry);
  const std::vector<Turn> turns = turns_of(scans);
  TurnAgreement best;
  const auto try_delay = [&](double delay_s) {
    const TurnAgreement agreement = agreement_at(turns, track, odometry.size(), delay_s);
    if (std::abs(agreement.correlation) > std::abs(best.correlation)) best = agreement;
  };
  try_delay(0);
  const int steps = static_cast<int>(delay_max_s / kCoarseStep_s);
  for (int step = 1; step <= steps; ++step) {
    try_delay(step * kCoarseStep_s);
    try_delay(-step * kCoarseStep_s);
  }
  const double coarse_s = best.delay_s;
  constexpr int kFineSteps = 5;
  for (int step = -kFineSteps; step <= kFineSteps; ++step) try_delay(coarse_s + step * kFineStep_s);
  return best;
}

std::vector<MotionPair> motion_pairs(const SampledMotion& scans, std::span<const OdometrySample> odometry,
                                     double delay_s) {
  const OdometryTrack track(odometry);
  std::vector<MotionPair> pairs;
  std::size_t from = 0;
  Mat3 covariance = Mat3::Zero();
  for (std::size_t i = 1; i < scans.times_s.size(); ++i) {
    covariance += (scans.information[i] + Mat3::Identity()).inverse();
    const Pose2 laser = between(scans.T_first_laser[from], scans.T_first_laser[i]);
    if (laser.position().norm() < kPieceMin_m && std::abs(laser.theta) < kPieceMin_rad) continue;
    const double from_s = scans.times_s[from], to_s = scans.times_s[i];
    pairs.push_back(
        {from_s, to_s, laser, covariance.inverse(),
         between(track.at(from_s - delay_s, odometry.size()), track.at(to_s - delay_s, odometry.size()))});
    from = i;
    covariance.setZero();
  }
  return pairs;
}

bool MountingEstimator::add(const Pose2& T_map_laser, const Pose2& T_odom_vehicle) {
  if (!from_) {
    from_.emplace(T_map_laser, T_odom_vehicle);
    return false;
  }
  const Pose2 laser = between(from_->first, T_map_laser);
  if (laser.position().norm() < kPieceMin_m && std::abs(laser.theta) < kPieceMin_rad) return false;
  pairs_.push_back(
      {0, 0, laser, kTrackedInformation * Mat3::Identity(), between(from_->second, T_odom_vehicle)});
  from_.emplace(T_map_laser, T_odom_vehicle);
  if (pairs_.size() % kPiecesMin != 0) return false;
  found_ = find_mounting(pairs_);
  return found_.has_value();
}

Pose2 MountingEstimator::T_vehicle_laser(const Pose2& given) const {
  return found_ ? significant(*found_, given) : given;
}

Pose2 significant(const FoundMounting& found, const Pose2& given) {
  Pose2 T_vehicle_laser = given;
  const Vec2 off_m = found.T_vehicle_laser.position() - given.position();
  const double off_rad = wrap_angle(found.T_vehicle_laser.theta - given.theta);
  if (off_m.norm() > std::max(kSure * found.sigma_m, kOffsetMin_m)) {
    T_vehicle_laser.x = found.T_vehicle_laser.x;
    T_vehicle_laser.y = found.T_vehicle_laser.y;
  }
  if (std::abs(off_rad) > std::max(kSure * found.sigma_rad, kHeadingMin_rad))
    T_vehicle_laser.theta = found.T_vehicle_laser.theta;
  return T_vehicle_laser;
}

/// (R(turn) - I) t - R(psi) laser = -vehicle, two rows a pair; cos and sin of psi are free, and made one of
/// unit length afterwards.
std::optional<FoundMounting> find_mounting(std::span<const MotionPair> pairs) {
  using Mat4 = Eigen::Matrix4d;
  using Vec4 = Eigen::Vector4d;
  struct Row {
    Eigen::Matrix<double, 2, 4> slope;
    Vec2 value;
    double sigma_m;
  };
  std::vector<Row> rows;
  for (const MotionPair& pair : pairs) {
    const double c = std::cos(pair.vehicle.theta), s = std::sin(pair.vehicle.theta);
    const Vec2 p = pair.laser.position();
    Row row;
    row.slope << c - 1, -s, -p.x(), p.y(), s, c - 1, -p.y(), -p.x();
    row.value = -pair.vehicle.position();
    row.sigma_m = kPairSigma_m + kOdometryShare * p.norm() +
                  std::sqrt(std::max(0.0, pair.information.inverse().topLeftCorner<2, 2>().trace()));
    rows.push_back(row);
  }
  if (rows.size() < kPiecesMin) return std::nullopt;
  Vec4 solution(0, 0, 1, 0);
  Mat4 information;
  double variance = 1;
  for (int round = 0; round < kRobustRounds; ++round) {
    information.setZero();
    Vec4 pull = Vec4::Zero();
    double squares = 0, weights = 0;
    for (const Row& row : rows) {
      const Vec2 off = (row.slope * solution - row.value) / row.sigma_m;
      const double robust = round == 0 ? 1 : 1 / (1 + off.squaredNorm() / 4);
      const double weight = robust / square(row.sigma_m);
      information += weight * row.slope.transpose() * row.slope;
      pull += weight * row.slope.transpose() * row.value;
      squares += robust * off.squaredNorm();
      weights += 2 * robust;
    }
    const auto solver = information.ldlt();
    if (solver.info() != Eigen::Success || solver.vectorD().minCoeff() <= 1e-9) return std::nullopt;
    solution = solver.solve(pull);
    variance = std::max(1.0, squares / weights);
  }
  const Mat4 covariance = variance * information.inverse();
  const double scale = solution.tail<2>().norm();
  if (scale < 0.5 || scale > 2) return std::nullopt;
  return FoundMounting{{solution(0), solution(1), std::atan2(solution(3), solution(2))},
                       std::sqrt(std::max(covariance(0, 0), covariance(1, 1))),
                       std::sqrt(std::max(covariance(2, 2), covariance(3, 3))) / scale};
}

}  // namespace aisle
