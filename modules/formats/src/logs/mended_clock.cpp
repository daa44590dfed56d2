#include "logs/mended_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "logs/rounded_stamps.hpp"

namespace aisle {
namespace {

constexpr double kLongestStep_s = 60;
constexpr int kStillAllowed = 1;  // one stamp twice happens to good clocks
constexpr double kPlausibleSpeed_mps = 0.5;
constexpr double kPlausibleTurn_radps = 30 * kDegree;

double plausible_time_s(const Pose2& from, const Pose2& to) {
  const Pose2 motion = between(from, to);
  return std::max({kNominalStep_s, motion.position().norm() / kPlausibleSpeed_mps,
                   std::abs(motion.theta) / kPlausibleTurn_radps});
}

std::vector<double> plausible_steps_s(std::span<const double> stamps_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps_s.size(); ++i) {
    const double step = stamps_s[i] - stamps_s[i - 1];
    if (step >= 0 && step <= kLongestStep_s) steps.push_back(step);
  }
  return steps;
}

/// The stamps of one kind of message, in recording order.
class StampStream {
 public:
  explicit StampStream(std::vector<double> stamps_s, std::vector<long> lines)
      : stamps_s_(std::move(stamps_s)), lines_(std::move(lines)) {
    const std::size_t first = spread_rounded_stamps(stamps_s_);
    if (first < lines_.size()) first_rounded_line_ = lines_[first];
    std::vector<double> steps_s = plausible_steps_s(stamps_s_);
    const auto telling =
        steps_s.size() - static_cast<std::size_t>(std::count(steps_s.begin(), steps_s.end(), 0.0));
    is_useless_ = stamps_s_.size() > 1 && 2 * telling < stamps_s_.size() - 1;
    usual_step_s_ = steps_s.empty() ? 0 : median(std::move(steps_s));
  }

  /// Most steps make no sense.
  bool is_useless() const { return is_useless_; }

  /// The repaired time of the next stamp. `shift_s` is the clock's offset so far; it changes where a step
  /// makes no sense.
  /// @param T_odom_vehicle  as far as it is known by then
  double next_time(const Pose2& T_odom_vehicle, double& shift_s, ClockRepair& repair) {
    const double stamp_s = stamps_s_[next_];
    const long line = lines_[next_++];
    const Pose2 from = std::exchange(T_odom_vehicle_, T_odom_vehicle);
    const double time_s = stamp_s + shift_s;
    if (next_ == 1) return time_s_ = time_s;
    const double step_s = time_s - time_s_;
    still_ = step_s == 0 ? still_ + 1 : 0;
    if (step_s >= 0 && step_s <= kLongestStep_s && still_ <= kStillAllowed) return time_s_ = time_s;
    if (repair.places++ == 0) repair.first_line = line;
    const double by_motion_s = plausible_time_s(from, T_odom_vehicle);
    const bool guess = by_motion_s > kNominalStep_s && by_motion_s > usual_step_s_;
    repair.by_motion |= guess;
    time_s_ += guess ? by_motion_s : usual_step_s_;
    shift_s = time_s_ - stamp_s;
    return time_s_;
  }

  long first_rounded_line() const { return first_rounded_line_; }

 private:
  std::vector<double> stamps_s_;
  std::vector<long> lines_;
  long first_rounded_line_ = 0;
  bool is_useless_ = false;
  double usual_step_s_ = 0;
  std::size_t next_ = 0;
  double time_s_ = 0;  ///< of the latest stamp
  Pose2 T_odom_vehicle_;
  int still_ = 0;  ///< number of stamps since the clock last moved
};

StampStream scan_stamps(const LaserLog& log) {
  std::vector<double> stamps_s;
  std::vector<long> lines;
  for (const LaserScan& scan : log.scans) {
    stamps_s.push_back(scan.stamp_s);
    lines.push_back(scan.line);
  }
  return StampStream(std::move(stamps_s), std::move(lines));
}

StampStream odometry_stamps(const LaserLog& log) {
  std::vector<double> stamps_s;
  std::vector<long> lines;
  for (const OdometrySample& sample : log.odometry) {
    stamps_s.push_back(sample.time_s);
    lines.push_back(sample.line);
  }
  return StampStream(std::move(stamps_s), std::move(lines));
}

/// Times of a recording whose stamps say nothing: in file order, with the motion's plausible time.
ClockRepair time_by_motion(LaserLog& log) {
  ClockRepair repair{log.scans.size() - 1, log.scans.size() > 1 ? log.scans[1].line : 0, true};
  double time_s = log.scans.front().stamp_s;
  std::size_t sample = 0;
  const auto take_odometry_until = [&](std::size_t count) {
    for (; sample < count; ++sample) {
      OdometrySample& next = log.odometry[sample];
      if (sample > 0)
        time_s += plausible_time_s(log.odometry[sample - 1].T_odom_vehicle, next.T_odom_vehicle);
      next.time_s = time_s;
    }
  };
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const bool has_moved = log.scans[i].odometry_known > sample;
    if (i > 0 && !has_moved) time_s += kNominalStep_s;
    take_odometry_until(log.scans[i].odometry_known);
    log.scans[i].time_s = time_s;
  }
  take_odometry_until(log.odometry.size());
  return repair;
}

}  // namespace

ClockRepair mend_clock(LaserLog& log) {
  if (log.scans.empty()) return {};
  StampStream scans = scan_stamps(log);
  StampStream odometry = odometry_stamps(log);
  if (scans.is_useless() || odometry.is_useless()) return time_by_motion(log);
  ClockRepair repair;
  double shift_s = 0;
  std::size_t sample = 0;
  const auto take_odometry_until = [&](std::size_t count) {
    for (; sample < count; ++sample) {
      OdometrySample& next = log.odometry[sample];
      next.time_s = odometry.next_time(next.T_odom_vehicle, shift_s, repair);
    }
  };
  for (LaserScan& scan : log.scans) {
    take_odometry_until(scan.odometry_known);
    const Pose2 T_odom_vehicle = sample > 0 ? log.odometry[sample - 1].T_odom_vehicle : Pose2{};
    scan.time_s = scans.next_time(T_odom_vehicle, shift_s, repair);
  }
  take_odometry_until(log.odometry.size());
  repair.first_rounded_line =
      scans.first_rounded_line() > 0 ? scans.first_rounded_line() : odometry.first_rounded_line();
  return repair;
}

void mend_clock(LaserLog& log, const std::string& name, Problems& warnings) {
  const ClockRepair repair = mend_clock(log);
  if (repair.first_rounded_line > 0) {
    warnings.push_back({{name, repair.first_rounded_line},
                        "stamps are rounded: many in a row are equal, first here; they are spread evenly"});
  }
  if (repair.places == 0) return;
  warnings.push_back(
      {{name, repair.first_line},
       fmt::format(
           "stamps go back, jump or stand still at {} places, first here; scans are taken in file order{}",
           repair.places, repair.by_motion ? ", with times guessed from how far the vehicle moved" : "")});
}

}  // namespace aisle
