#include "logs/mended_clock.hpp"

#include <utility>
#include <vector>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

constexpr double kLongestStep_s = 60;

/// The median of the plausible steps; 0 if there are none.
double usual_step_s(std::span<const RecordedStamp> stamps) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const double step = stamps[i].stamp_s - stamps[i - 1].stamp_s;
    if (step >= 0 && step <= kLongestStep_s) steps.push_back(step);
  }
  if (steps.empty()) return 0;
  return median(std::move(steps));
}

/// The stamps of one kind of message, in recording order.
class StampStream {
 public:
  explicit StampStream(std::span<const RecordedStamp> stamps)
      : stamps_(stamps), usual_step_s_(usual_step_s(stamps)) {}

  /// The repaired time of the next stamp. `shift_s` is the clock's offset so far; it changes where a step
  /// makes no sense.
  double next_time(double& shift_s, ClockRepair& repair) {
    const RecordedStamp& recorded = stamps_[next_++];
    const double time_s = recorded.stamp_s + shift_s;
    if (next_ == 1) return time_s_ = time_s;
    const double step_s = time_s - time_s_;
    still_ = step_s == 0 ? still_ + 1 : 0;
    if (step_s >= 0 && step_s <= kLongestStep_s && still_ < 2) return time_s_ = time_s;
    if (repair.places++ == 0) repair.first_line = recorded.line;
    repair.by_nominal_step |= usual_step_s_ == 0;
    time_s_ += usual_step_s_ > 0 ? usual_step_s_ : kNominalStep_s;
    shift_s = time_s_ - recorded.stamp_s;
    return time_s_;
  }

 private:
  std::span<const RecordedStamp> stamps_;
  double usual_step_s_;
  std::size_t next_ = 0;
  double time_s_ = 0;  ///< of the latest stamp
  int still_ = 0;      ///< number of stamps since the clock last moved
};

}  // namespace

ClockRepair mend_clock(LaserLog& log, std::span<const RecordedStamp> scans,
                       std::span<const RecordedStamp> odometry) {
  ClockRepair repair;
  double shift_s = 0;
  StampStream scan_stream(scans);
  StampStream odometry_stream(odometry);
  std::size_t sample = 0;
  const auto take_odometry_until = [&](std::size_t count) {
    for (; sample < count; ++sample) log.odometry[sample].time_s = odometry_stream.next_time(shift_s, repair);
  };
  for (LaserScan& scan : log.scans) {
    take_odometry_until(scan.odometry_known);
    scan.time_s = scan_stream.next_time(shift_s, repair);
  }
  take_odometry_until(log.odometry.size());
  return repair;
}

}  // namespace aisle
