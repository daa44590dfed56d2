#include "walls/odometry_leaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "aisle/core/median.hpp"
#include "aisle/learning/walls/scan_odometry.hpp"
#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr double kLeap_m = 0.3;  // shorter steps are left to the tracker ...
constexpr double kLeap_rad = 20 * kDegree;
constexpr double kUsualSteps = 5;         // ... and so are those of less than this many usual ones
constexpr std::size_t kScansBefore = 30;  // that are asked
constexpr double kConfirmingGain = 0.1;
constexpr double kConfirmingShare = 0.5;
constexpr double kLate_s = 5;  // odometry may stand still for this long before it catches up
constexpr double kCatchUpSpeed_mps = 1.5;
constexpr double kCatchUpTurn_radps = 2;
constexpr double kToldShare = 0.3;  // of the motion, by odometry that is late
constexpr double kSameMotion_m = 0.4;
constexpr double kSameMotion_rad = 20 * kDegree;
constexpr std::size_t kLeapsSaid = 5;
constexpr std::size_t kLeapsMax = 100;  // odometry that leaps more often is beyond repair
constexpr double kMoves_m = 1e-3;
constexpr double kMoves_rad = 1e-3;

bool is_motion(const Pose2& step) {
  return step.position().norm() > kMoves_m || std::abs(step.theta) > kMoves_rad;
}

/// The median steps of odometry that moves.
struct UsualStep {
  double moved_m = 0;
  double turned_rad = 0;
};

UsualStep usual_step(const std::vector<OdometrySample>& odometry) {
  std::vector<double> moved_m, turned_rad;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Pose2 step = between(odometry[i - 1].T_odom_vehicle, odometry[i].T_odom_vehicle);
    if (step.position().norm() > kMoves_m) moved_m.push_back(step.position().norm());
    if (std::abs(step.theta) > kMoves_rad) turned_rad.push_back(std::abs(step.theta));
  }
  return {moved_m.empty() ? 0 : median(std::move(moved_m)),
          turned_rad.empty() ? 0 : median(std::move(turned_rad))};
}

/// Whether no vehicle moves like this in that time.
bool is_leap(const Pose2& step, double step_s, const UsualStep& usual) {
  const double moved_m = step.position().norm(), turned_rad = std::abs(step.theta);
  return moved_m > std::max({kLeap_m, kVehicleSpeedMax_mps * step_s, kUsualSteps * usual.moved_m}) ||
         turned_rad > std::max({kLeap_rad, kVehicleTurnMax_radps * step_s, kUsualSteps * usual.turned_rad});
}

/// What the scans around a step of the odometry show.
class ScanWitness {
 public:
  /// @param scan  the first at or after the step; not the first of the log
  ScanWitness(const LaserLog& log, std::size_t scan) {
    const std::size_t laser = log.scans[scan].laser;
    const Pose2 T_laser_vehicle = log.lasers[laser].T_vehicle_laser.inverse();
    std::vector<Vec2> points;
    for (std::size_t i = scan - std::min(scan, kScansBefore); i <= scan; ++i) {
      if (log.scans[i].laser != laser) continue;
      points_of(log.laser_of(log.scans[i]), log.scans[i].ranges_m, points);
      if (i == scan) before_ = scans_;
      const ScanMotion motion = scans_.step(points, log.scans[i].time_s);
      track_.push_back({log.scans[i].time_s, scans_.T_first_laser() * T_laser_vehicle});
      shares_.push_back(motion.share);
    }
    points_ = std::move(points);
    T_vehicle_laser_ = log.lasers[laser].T_vehicle_laser;
  }

  double from_s() const { return track_.front().time_s; }
  double last_s() const { return track_.back().time_s; }
  double before_last_s() const { return track_[track_.size() < 2 ? 0 : track_.size() - 2].time_s; }

  /// The motion of the vehicle from a moment to the last scan; nullopt if the scans in between do not fit
  /// each other.
  std::optional<Pose2> motion_since(double time_s) const {
    for (std::size_t i = track_.size(); i-- > 1 && track_[i].time_s > time_s;) {
      if (shares_[i] < kConfirmingShare) return std::nullopt;
    }
    const OdometryTrack track(track_);
    return between(track.at(time_s, track_.size()), track_.back().T_odom_vehicle);
  }

  /// Whether the last scan fits the ones before as well after this motion of the vehicle as anywhere.
  bool confirms(const Pose2& T_last_now) {
    const Pose2 laser = between(T_vehicle_laser_, T_last_now * T_vehicle_laser_);
    const double share = before_.share_at(points_, laser);
    return share > kConfirmingShare && share > shares_.back() - kConfirmingGain;
  }

 private:
  ScanOdometry scans_, before_;
  std::vector<Vec2> points_;  ///< of the last scan
  std::vector<OdometrySample> track_;
  std::vector<double> shares_;
  Pose2 T_vehicle_laser_;
};

class LeapCorrection {
 public:
  explicit LeapCorrection(LaserLog& log)
      : log_(log), odometry_(log.odometry), usual_(usual_step(log.odometry)) {}

  Problems run() {
    for (std::size_t i = 1; i < odometry_.size(); ++i) {
      odometry_[i].T_odom_vehicle = T_old_new_ * odometry_[i].T_odom_vehicle;
      const Pose2 step = between(pose(i - 1), pose(i));
      if (leaps_ < kLeapsMax && is_leap(step, odometry_[i].time_s - odometry_[i - 1].time_s, usual_))
        correct(i, step);
    }
    if (leaps_ > kLeapsSaid) {
      warn(0, fmt::format("the odometry leaps at {}{} more places", leaps_ == kLeapsMax ? "at least " : "",
                          leaps_ - kLeapsSaid));
    }
    return std::move(warnings_);
  }

 private:
  const Pose2& pose(std::size_t sample) const { return odometry_[sample].T_odom_vehicle; }

  void warn(long line, std::string what) {
    Problem warning;
    warning.where.line = line;
    warning.what = std::move(what);
    warnings_.push_back(std::move(warning));
  }

  /// Settles a step that no vehicle makes: confirmed by the scans, or made up for time lost, or a new frame.
  void correct(std::size_t sample, const Pose2& step) {
    while (scan_ < log_.scans.size() && log_.scans[scan_].time_s < odometry_[sample].time_s) ++scan_;
    if (scan_ == 0 || scan_ >= log_.scans.size()) return;
    ScanWitness witness(log_, scan_);
    const Pose2 until = motion(sample - 1, witness.before_last_s(), odometry_[sample - 1].time_s);
    const Pose2 since = motion_after(sample, witness.last_s());
    if (witness.confirms(until * step * since)) return;
    ++leaps_;
    const std::string leap = fmt::format("the odometry leaps by {:.2f} m and {:.0f} degrees",
                                         step.position().norm(), to_degrees(step.theta));
    if (const auto begin = late_since(sample, witness)) {
      const bool stood_still = !is_motion(between(pose(*begin), pose(sample - 1)));
      say(sample, fmt::format("{} after {:.1f} s in which it {}; the motion is spread over that time", leap,
                              odometry_[sample].time_s - odometry_[*begin].time_s,
                              stood_still ? "stood still" : "told little"));
      return spread(*begin, sample);
    }
    const auto by_scans = witness.motion_since(witness.before_last_s());
    say(sample, leap + (by_scans ? "; the scans before and after tell how it went on"
                                 : "; the scans cannot tell how it went on: taken for standing still"));
    const Pose2 corrected =
        by_scans ? pose(sample - 1) * until.inverse() * *by_scans * since.inverse() : pose(sample - 1);
    T_old_new_ = corrected * pose(sample).inverse() * T_old_new_;
    odometry_[sample].T_odom_vehicle = corrected;
  }

  void say(std::size_t sample, std::string what) {
    if (leaps_ <= kLeapsSaid) warn(odometry_[sample].line, std::move(what));
  }

  /// The motion by the odometry up to a sample between two moments, and from a sample on; the samples after
  /// it are still in the frame as recorded.
  Pose2 motion(std::size_t last_sample, double from_s, double to_s) const {
    const OdometryTrack track(std::span<const OdometrySample>(odometry_).first(last_sample + 1));
    return between(track.at(from_s, last_sample + 1), track.at(to_s, last_sample + 1));
  }
  Pose2 motion_after(std::size_t sample, double until_s) const {
    std::size_t last = sample;
    while (last + 1 < odometry_.size() && odometry_[last + 1].time_s <= until_s) ++last;
    return last == sample ? Pose2{} : between(T_old_new_.inverse() * pose(sample), pose(last));
  }

  /// The sample after which the odometry was late, if the step only catches up: over the time since then the
  /// motion is one that a vehicle makes, and the scans show the same; if they cannot tell, it told little.
  std::optional<std::size_t> late_since(std::size_t sample, const ScanWitness& witness) const {
    const double until_s = odometry_[sample].time_s;
    for (std::size_t begin = sample - 1; begin-- > 0;) {
      const double late_s = until_s - odometry_[begin].time_s;
      if (late_s > kLate_s || odometry_[begin].time_s < witness.from_s()) break;
      const Pose2 whole = between(pose(begin), pose(sample));
      if (whole.position().norm() > kCatchUpSpeed_mps * late_s ||
          std::abs(whole.theta) > kCatchUpTurn_radps * late_s)
        continue;
      if (begin > 0 && begin + 1 < sample && !is_motion(between(pose(begin - 1), pose(begin)))) continue;
      const auto by_scans = witness.motion_since(odometry_[begin].time_s);
      if (!by_scans) return was_late(begin, sample) ? std::optional(begin) : std::nullopt;
      const Pose2 off = between(whole, *by_scans);
      if (off.position().norm() < kSameMotion_m && std::abs(off.theta) < kSameMotion_rad) return begin;
      return std::nullopt;
    }
    return std::nullopt;
  }

  /// Whether the odometry told little of the motion before the step: it hardly moved, or there was none.
  bool was_late(std::size_t begin, std::size_t sample) const {
    const Pose2 whole = between(pose(begin), pose(sample)), told = between(pose(begin), pose(sample - 1));
    if (told.position().norm() <= kToldShare * whole.position().norm() &&
        std::abs(told.theta) <= kToldShare * std::abs(whole.theta))
      return true;
    double gap_s = 0;
    for (std::size_t i = begin + 1; i <= sample; ++i)
      gap_s = std::max(gap_s, odometry_[i].time_s - odometry_[i - 1].time_s);
    return gap_s > 0.5 * (odometry_[sample].time_s - odometry_[begin].time_s);
  }

  void spread(std::size_t begin, std::size_t end) {
    const double from_s = odometry_[begin].time_s, whole_s = odometry_[end].time_s - from_s;
    for (std::size_t i = begin + 1; i < end; ++i)
      odometry_[i].T_odom_vehicle =
          interpolate(pose(begin), pose(end), (odometry_[i].time_s - from_s) / whole_s);
  }

  LaserLog& log_;
  std::vector<OdometrySample>& odometry_;
  UsualStep usual_;
  Problems warnings_;
  Pose2 T_old_new_;  ///< from the frame of the odometry as recorded to its frame before the leaps
  std::size_t leaps_ = 0;
  std::size_t scan_ = 0;  ///< the first at or after the current step
};

}  // namespace

Problems correct_leaps(LaserLog& log) {
  return log.odometry.size() < 2 ? Problems{} : LeapCorrection(log).run();
}

}  // namespace aisle
