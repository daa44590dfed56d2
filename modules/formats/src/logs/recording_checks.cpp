#include "logs/recording_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/median.hpp"
#include "logs/carmen_range.hpp"
#include "logs/heading_unit.hpp"
#include "logs/occurrences.hpp"

namespace aisle {
namespace {

constexpr double kNoMetres_m = 300;  // no scanner's median reading
constexpr double kHardlyMetres_m = 60;
constexpr double kHardlyUnits_m = 0.3;

void check_unit(LaserRecording& recording, LengthUnit unit, const std::string& name, Problems& problems) {
  const double median_m = median_reading_m(recording.log);
  if (unit == LengthUnit::kMetre && median_m > kNoMetres_m) {
    problems.push_back({{name},
                        fmt::format("half of the readings are above {:.0f} m: no scanner sees so far; say "
                                    "--units mm if they are millimetres, --units cm if centimetres",
                                    median_m)});
  } else if (unit == LengthUnit::kMetre && median_m > kHardlyMetres_m) {
    recording.warnings.push_back({{name},
                                  fmt::format("half of the readings are above {:.0f} m: if they are "
                                              "centimetres, say --units cm; if millimetres, --units mm",
                                              median_m)});
  }
  if (unit != LengthUnit::kMetre && median_m > 0 && median_m < kHardlyUnits_m) {
    const char* said = unit == LengthUnit::kCentimetre ? "cm" : "mm";
    recording.warnings.push_back({{name},
                                  fmt::format("half of the readings are below {:.3f} m: if they are metres, "
                                              "leave out --units {}",
                                              median_m, said)});
  }
}

/// Motion from one odometry sample to the next.
struct RecordedStep {
  double distance_m, turn_rad, time_s;

  double speed_mps() const { return distance_m / std::max(time_s, 1e-3); }
  double rate_radps() const { return turn_rad / std::max(time_s, 1e-3); }
};

RecordedStep step_before(const std::vector<OdometrySample>& odometry, std::size_t i) {
  const Pose2 motion = between(odometry[i - 1].T_odom_vehicle, odometry[i].T_odom_vehicle);
  return {motion.position().norm(), std::abs(motion.theta), odometry[i].time_s - odometry[i - 1].time_s};
}

double high_quantile(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

void check_speed(LaserRecording& recording, const std::string& name) {
  constexpr double kMoving_mps = 0.01, kNoVehicle_mps = 20;
  std::vector<double> speeds;
  for (std::size_t i = 1; i < recording.log.odometry.size(); ++i) {
    const RecordedStep step = step_before(recording.log.odometry, i);
    if (step.time_s > 0 && step.speed_mps() > kMoving_mps) speeds.push_back(step.speed_mps());
  }
  if (speeds.empty()) return;
  const double usual_mps = median(std::move(speeds));
  if (usual_mps < kNoVehicle_mps) return;
  recording.warnings.push_back(
      {{name},
       fmt::format("the vehicle usually drives at {:.0f} m/s: are its poses centimetres or "
                   "millimetres, or are the stamps no seconds?",
                   usual_mps)});
}

/// What this vehicle does not do from one sample to the next, judged by what it mostly does.
struct JumpLimits {
  double speed_mps, rate_radps;

  explicit JumpLimits(const std::vector<OdometrySample>& odometry) {
    std::vector<double> speeds, rates;
    for (std::size_t i = 1; i < odometry.size(); ++i) {
      const RecordedStep step = step_before(odometry, i);
      if (step.time_s <= 0) continue;
      speeds.push_back(step.speed_mps());
      rates.push_back(step.rate_radps());
    }
    speed_mps = std::max(5.0, 4 * high_quantile(std::move(speeds)));
    rate_radps = std::max(6.0, 4 * high_quantile(std::move(rates)));
  }

  bool is_jump(const RecordedStep& step) const {
    constexpr double kFar_m = 20;  // no vehicle drives that far from one line to the next
    if (step.distance_m > kFar_m) return true;
    return (step.distance_m > 1 && step.speed_mps() > speed_mps) ||
           (step.turn_rad > 90 * kDegree && step.rate_radps() > rate_radps);
  }
};

void check_jumps(LaserRecording& recording, const std::string& name) {
  const std::vector<OdometrySample>& odometry = recording.log.odometry;
  const JumpLimits limits(odometry);
  Occurrences jumps;
  RecordedStep first = {};
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const RecordedStep step = step_before(odometry, i);
    if (!limits.is_jump(step)) continue;
    if (jumps.count == 0) first = step;
    jumps.add(odometry[i].line);
  }
  if (jumps.count == 0) return;
  recording.warnings.push_back(
      {{name, jumps.first_line},
       fmt::format("the odometry jumps by {:.1f} m, {:.0f} deg from the pose before; {} such jumps",
                   first.distance_m, to_degrees(first.turn_rad), jumps.count)});
}

/// Motion from the scan before.
RecordedStep motion_to_scan(const LaserLog& log, std::size_t i) {
  const std::size_t from = log.scans[i - 1].odometry_known, to = log.scans[i].odometry_known;
  const double time_s = log.scans[i].time_s - log.scans[i - 1].time_s;
  if (from == 0 || to == 0) return {0, 0, time_s};
  const Pose2 motion = between(log.odometry[from - 1].T_odom_vehicle, log.odometry[to - 1].T_odom_vehicle);
  return {motion.position().norm(), std::abs(motion.theta), time_s};
}

void check_gaps(LaserRecording& recording, const std::string& name) {
  constexpr double kGap_m = 1.5;
  constexpr double kGapInSteps = 8;
  constexpr std::size_t kGapsShown = 5;
  std::size_t gaps = 0;
  const LaserLog& log = recording.log;
  const JumpLimits limits(log.odometry);
  std::vector<double> steps_m;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    const double step_m = motion_to_scan(log, i).distance_m;
    if (step_m > 0.01) steps_m.push_back(step_m);
  }
  if (steps_m.empty()) return;
  const double usual_m = median(std::move(steps_m));
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    const RecordedStep step = motion_to_scan(log, i);
    if (step.distance_m < std::max(kGap_m, kGapInSteps * usual_m) || limits.is_jump(step)) continue;
    if (++gaps > kGapsShown) continue;
    recording.warnings.push_back(
        {{name, log.scans[i].line},
         fmt::format("scans are missing before this one: {:.1f} m of odometry and {:.1f} s without any",
                     step.distance_m, step.time_s)});
  }
  if (gaps > kGapsShown) {
    recording.warnings.push_back({{name}, fmt::format("... and {} more such gaps", gaps - kGapsShown)});
  }
}

}  // namespace

Problems check_recording(LaserRecording& recording, LengthUnit unit, const std::string& name) {
  Problems problems;
  if (recording.log.odometry.empty()) {
    recording.warnings.push_back({{name}, "has no odometry: there are scans, but no poses"});
  }
  check_unit(recording, unit, name, problems);
  check_heading_unit(recording, name, problems);
  check_speed(recording, name);
  check_jumps(recording, name);
  check_gaps(recording, name);
  return problems;
}

}  // namespace aisle
