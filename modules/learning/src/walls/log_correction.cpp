#include "aisle/learning/walls/log_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/learning/walls/scanner_calibration.hpp"
#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr double kStandingStill_m = 0.2;           // of odometry over a whole run ...
constexpr double kStandingStill_rad = 0.2;         // ... that the scans show to move more than this
constexpr double kTellingTurn_rad = 60 * kDegree;  // with less turning, the scans say nothing of the odometry
constexpr double kTellingShare = 0.8;              // so well the scans must fit one another
constexpr double kContrary = -0.7;                 // correlation of turns
constexpr double kInCommon = 0.7;
constexpr double kSlopeOff = 0.15;      // other beams are tried if the turns differ by more than this share
constexpr double kDelaysOfMapping = 3;  // scan periods: shorter delays are estimated while mapping
constexpr double kNearDelay_s = 2;
constexpr double kFarDelay_s = 12;
constexpr double kClearGain = 0.005;  // of the correlation, by a delay that is more than chance ...
constexpr double kClearShare = 0.5;   // ... and this share of what it lacked without
constexpr double kFarMounting_m = 0.1;
constexpr double kFarMounting_rad = 10 * kDegree;
constexpr double kTellingSweep_rad = 2 * kDegree;  // of the vehicle during a scan
constexpr std::size_t kTellingScans = 20;          // while the vehicle turns
constexpr std::size_t kTellingScansMax = 300;
constexpr double kSweepGain = 0.02;  // of the share that fits, if the readings are measured in another order
constexpr double kTooSparseShare = 0.6;

/// Mirrors every scan: beam 0 becomes the last.
void mirror(LaserLog& log) {
  for (LaserScan& scan : log.scans) {
    const LaserScanner laser = log.laser_of(scan);
    const double last_rad = laser.beam_angle(scan.ranges_m.empty() ? 0 : scan.ranges_m.size() - 1);
    const double period_s = scan.beams ? scan.beams->period_s : 0;
    std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
    scan.beams = ScanBeams{-last_rad, laser.angle_step_rad, -period_s};
  }
}

double moved_m(std::span<const OdometrySample> odometry) {
  double moved_m = 0;
  for (std::size_t i = 1; i < odometry.size(); ++i)
    moved_m += between(odometry[i - 1].T_odom_vehicle, odometry[i].T_odom_vehicle).position().norm();
  return moved_m;
}

double turned_rad(std::span<const OdometrySample> odometry) {
  double turned_rad = 0;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    turned_rad +=
        std::abs(wrap_angle(odometry[i].T_odom_vehicle.theta - odometry[i - 1].T_odom_vehicle.theta));
  }
  return turned_rad;
}

/// How well the scans fit the ones before them while the vehicle turns, if their readings were measured in
/// the order that the log says (`direction` 1) or the other way round (-1). nullopt: there is no order, or
/// too little turning.
std::optional<double> share_in_turns(const LaserLog& log, double delay_s, int direction) {
  const OdometryTrack track(log.odometry);
  const auto T_odom_laser = [&](double time_s) {
    return track.at(time_s - delay_s, log.odometry.size()) * log.laser().T_vehicle_laser;
  };
  ScanOdometry scans;
  std::vector<Vec2> points;
  double shares = 0;
  std::size_t turning = 0;
  for (const LaserScan& scan : log.scans) {
    if (scan.laser != 0 || !scan.beams || scan.beams->period_s == 0) continue;
    const double half_s = 0.5 * direction * scan.beams->period_s * static_cast<double>(scan.ranges_m.size());
    const Pose2 swept = between(T_odom_laser(scan.time_s - half_s), T_odom_laser(scan.time_s + half_s));
    points_of(log.laser_of(scan), scan.ranges_m, points, swept);
    const double share = scans.step(points, scan.time_s).share;
    if (std::abs(swept.theta) < kTellingSweep_rad) continue;
    shares += share;
    if (++turning == kTellingScansMax) break;
  }
  if (turning < kTellingScans) return std::nullopt;
  return shares / static_cast<double>(turning);
}

class LogCorrection {
 public:
  LogCorrection(LaserLog& log, const OpenOfLog& open, Progress& progress)
      : log_(log), open_(open), progress_(progress) {}

  Result<LogFindings> run() {
    if (log_.scans.size() < 2) {
      if (log_.odometry.empty()) log_.odometry.push_back({log_.scans.front().time_s, {}, 0});
      return LogFindings{};
    }
    sample_ = sample_motion(log_, std::nullopt);
    if (has_no_odometry()) return replace_odometry();
    if (is_telling()) {
      agreement_ = compare_turns(sample_, log_.odometry, kNearDelay_s);
      if (agreement_.correlation < kContrary) correct_direction();
      if (std::abs(std::abs(agreement_.slope) - 1) > kSlopeOff) try_other_beams();
      if (agreement_.correlation < kInCommon) try_far_delays();
      if (agreement_.correlation > kInCommon) {
        correct_clock();
        if (open_.mounting) correct_mounting();
        correct_order();
      } else {
        warn(0, fmt::format(
                    "the turns by the odometry and by the scans have little in common (correlation {:.2f}): "
                    "one of the two is wrong",
                    agreement_.correlation));
      }
    }
    const double delay_s = agreement_.correlation > kInCommon ? agreement_.delay_s : 0;
    return LogFindings{std::move(warnings_), delay_s, false};
  }

 private:
  void warn(long line, std::string what) { warnings_.push_back({{"", line}, std::move(what)}); }

  bool is_telling() const {
    return sample_.median_share > kTellingShare && sample_.turned_rad() > kTellingTurn_rad;
  }

  bool has_no_odometry() const {
    if (log_.odometry.size() < 2) return true;
    const bool stands =
        moved_m(log_.odometry) < kStandingStill_m && turned_rad(log_.odometry) < kStandingStill_rad;
    return stands &&
           (sample_.moved_m() > 10 * kStandingStill_m || sample_.turned_rad() > 10 * kStandingStill_rad);
  }

  Result<LogFindings> replace_odometry() {
    const Pose2 T_laser_vehicle = log_.laser().T_vehicle_laser.inverse();
    ScanOdometry scans;
    std::vector<Vec2> points;
    std::vector<double> shares;
    std::vector<OdometrySample> odometry;
    for (std::size_t i = 0; i < log_.scans.size(); ++i) {
      LaserScan& scan = log_.scans[i];
      if (scan.laser == 0) {
        points_of(log_.laser_of(scan), scan.ranges_m, points);
        shares.push_back(scans.step(points, scan.time_s).share);
        odometry.push_back({scan.time_s, scans.T_first_laser() * T_laser_vehicle, scan.line});
      }
      scan.odometry_known = odometry.size();
      progress_.report("matching scans", i + 1, log_.scans.size());
    }
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 10);
    std::nth_element(shares.begin(), middle, shares.end());
    if (*middle < kTooSparseShare) {
      return Problem{
          {},
          fmt::format("has no odometry, and a tenth of the scans fit the scans before them by less than "
                      "{:.0f} %: they are too far apart to go without; from two scans per 0.3 m on it "
                      "works",
                      100 * kTooSparseShare)};
    }
    warn(log_.scans.front().line,
         log_.odometry.empty()
             ? "there is no odometry: mapped by the scans alone; whether the readings run clockwise cannot "
               "be seen, "
               "and along bare corridors the distance is a guess"
             : "the odometry stands still while the scans move: mapped by the scans alone; whether the "
               "readings run "
               "clockwise cannot be seen, and along bare corridors the distance is a guess");
    log_.odometry = std::move(odometry);
    return LogFindings{std::move(warnings_), 0, true};
  }

  void correct_direction() {
    mirror(log_);
    sample_ = sample_motion(log_, std::nullopt);
    agreement_ = compare_turns(sample_, log_.odometry, kNearDelay_s);
    warn(log_.scans.front().line,
         fmt::format(
             "the scans turn against the odometry (correlation {:.2f}): the readings run clockwise, or the "
             "scanner hangs upside down; they are taken the other way round",
             -agreement_.correlation));
  }

  /// The field of view that makes the scans turn as the odometry says.
  void try_other_beams() {
    const ScanBeams* best = nullptr;
    for (const ScanBeams& beams : open_.other_beams) {
      const SampledMotion sample = sample_motion(log_, beams);
      const TurnAgreement agreement = compare_turns(sample, log_.odometry, kNearDelay_s);
      if (sample.median_share < kTellingShare || agreement.correlation < kInCommon) continue;
      if (std::abs(agreement.slope - 1) >= std::abs(agreement_.slope - 1) &&
          agreement_.correlation > kInCommon)
        continue;
      best = &beams;
      sample_ = sample;
      agreement_ = agreement;
    }
    if (best == nullptr) return;
    for (LaserScan& scan : log_.scans) scan.beams = *best;
    const double field_rad = best->angle_step_rad * static_cast<double>(log_.scans.front().ranges_m.size());
    warn(log_.scans.front().line, fmt::format("nothing gives the angles of the readings; the scans turn as "
                                              "the odometry does with a field of view "
                                              "of {:.0f} degrees in steps of {:.3f}",
                                              to_degrees(field_rad), to_degrees(best->angle_step_rad)));
  }

  void try_far_delays() {
    const TurnAgreement far = compare_turns(sample_, log_.odometry, kFarDelay_s);
    if (far.correlation > kInCommon) agreement_ = far;
  }

  void correct_clock() {
    if (std::abs(agreement_.delay_s) < std::max(kDelaysOfMapping * log_.scan_period_s(), 0.2)) return;
    // Steady turning agrees at any delay.
    const TurnAgreement none = compare_turns(sample_, log_.odometry, 0);
    const double gain = agreement_.correlation - none.correlation;
    if (gain < std::max(kClearGain, kClearShare * (1 - none.correlation))) {
      agreement_ = none;
      return;
    }
    for (OdometrySample& sample : log_.odometry) sample.time_s += agreement_.delay_s;
    warn(log_.odometry.front().line,
         fmt::format("the odometry's stamps are {:.2f} s {} the scans'; they are shifted by that",
                     std::abs(agreement_.delay_s), agreement_.delay_s > 0 ? "behind" : "ahead of"));
    agreement_.delay_s = 0;
  }

  /// Only a mounting that is far off: the rest is found while mapping.
  void correct_mounting() {
    const auto found = find_mounting(motion_pairs(sample_, log_.odometry, agreement_.delay_s));
    if (!found) return;
    const Pose2 given = log_.laser().T_vehicle_laser;
    const Pose2 T_vehicle_laser = significant(*found, given);
    const Pose2 off = between(given, T_vehicle_laser);
    if (off.position().norm() < kFarMounting_m && std::abs(off.theta) < kFarMounting_rad) return;
    log_.laser().T_vehicle_laser = T_vehicle_laser;
    warn(
        0,
        fmt::format(
            "nothing says where the scanner sits; by the motion it is at x {:.2f} m, y {:.2f} m (+- {:.2f}), "
            "turned by {:.0f} degrees (+- {:.0f}) on the vehicle",
            T_vehicle_laser.x, T_vehicle_laser.y, found->sigma_m, to_degrees(T_vehicle_laser.theta),
            to_degrees(found->sigma_rad)));
  }

  /// Some drivers turn the readings of a clockwise scanner round, but not the time between them.
  void correct_order() {
    const auto as_given = share_in_turns(log_, agreement_.delay_s, 1);
    const auto reversed = share_in_turns(log_, agreement_.delay_s, -1);
    if (!as_given || !reversed || *reversed < *as_given + kSweepGain) return;
    for (LaserScan& scan : log_.scans) {
      if (scan.laser == 0 && scan.beams) scan.beams->period_s = -scan.beams->period_s;
    }
    warn(log_.scans.front().line,
         fmt::format("the last reading of a scan was measured first: in turns, {:.0f} % of the readings then "
                     "fit the scans before, instead of {:.0f} %",
                     100 * *reversed, 100 * *as_given));
  }

  LaserLog& log_;
  const OpenOfLog& open_;
  Progress& progress_;
  Problems warnings_;
  SampledMotion sample_;
  TurnAgreement agreement_;
};

}  // namespace

Result<LogFindings> correct_log(LaserLog& log, const OpenOfLog& open, Progress& progress) {
  return LogCorrection(log, open, progress).run();
}

}  // namespace aisle
