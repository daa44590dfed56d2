#include "aisle/formats/logs/counted_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "field_reader.hpp"
#include "logs/carmen_range.hpp"
#include "logs/left_out_lines.hpp"
#include "logs/mended_clock.hpp"
#include "logs/recording_checks.hpp"
#include "logs/scan_beams.hpp"
#include "logs/scan_readings.hpp"

namespace aisle {
namespace {

/// What the logs do not say of their robots: wheels or tracks left and right of the origin, and the scanner.
struct CountedRobot {
  const char* name;
  double step_m;   ///< of a wheel, per count
  double track_m;  ///< from wheel to wheel
  Pose2 T_vehicle_laser;
  double first_angle_rad, angle_step_rad;
  double void_below_m;  ///< such readings are error codes
  double range_max_m;
};

constexpr double kUrgStep_rad = 2 * kPi / 1024;

/// BreezySLAM's examples/mines.py: wheels of 77 mm, 2000 counts a turn; 682 readings about straight ahead.
const CountedRobot kRover{.name = "the rover of Mines ParisTech",
                          .step_m = 2 * kPi * 0.077 / 2000,
                          .track_m = 2 * 0.165,
                          .T_vehicle_laser = {0.145, 0, 0},
                          .first_angle_rad = -341 * kUrgStep_rad,
                          .angle_step_rad = kUrgStep_rad,
                          .void_below_m = 0.02,
                          .range_max_m = 5.6};

/// lego_robot.py and the texts of the course.
const CountedRobot kLego{.name = "the Lego robot of Brenner's course",
                         .step_m = 0.000349,
                         .track_m = 0.155,
                         .T_vehicle_laser = {0.03, 0, 0},
                         .first_angle_rad = -330 * kUrgStep_rad - 4 * kDegree,
                         .angle_step_rad = kUrgStep_rad,
                         .void_below_m = 0.02,
                         .range_max_m = 5.6};

constexpr std::size_t kReadingsMax = 2000;
constexpr double kNumberMax = 1e12;

struct Counts {
  double left = 0, right = 0;
};

/// Gathers scans and counts in the order of time.
class CountedLog {
 public:
  CountedLog(const CountedRobot& robot, const std::string& name) : robot_(robot), name_(name) {}

  void add_counts(double stamp_s, const Counts& counts, long line) {
    if (last_) {
      const double left_m = robot_.step_m * (counts.left - last_->left);
      const double right_m = robot_.step_m * (counts.right - last_->right);
      const double turn_rad = (right_m - left_m) / robot_.track_m, middle_m = (left_m + right_m) / 2;
      T_odom_vehicle_ = T_odom_vehicle_ * Pose2{middle_m * std::cos(turn_rad / 2),
                                                middle_m * std::sin(turn_rad / 2), wrap_angle(turn_rad)};
    }
    last_ = counts;
    recording_.log.odometry.push_back({stamp_s, T_odom_vehicle_, line});
  }

  void add_scan(double stamp_s, const std::vector<double>& readings_mm, long line) {
    LaserScan scan;
    scan.stamp_s = stamp_s;
    scan.line = line;
    scan.odometry_known = recording_.log.odometry.size();
    scan.ranges_m.reserve(readings_mm.size());
    for (const double reading_mm : readings_mm) {
      const double reading_m = reading_mm / 1000;
      scan.ranges_m.push_back(reading_m < robot_.void_below_m ? 0.0F : readings_.kept(reading_m, line));
    }
    scan.beams = ScanBeams{robot_.first_angle_rad, robot_.angle_step_rad};
    recording_.log.scans.push_back(std::move(scan));
  }

  void leave_out(long line, const std::string& why) { left_out_.add(line, why); }

  Result<LaserRecording> finish(const RecordingOptions& options) && {
    if (recording_.log.scans.empty()) return Problem{{name_}, "has no scan that can be read"};
    left_out_.warn(name_, recording_.warnings);
    warn(0, fmt::format("does not say how its robot counts and where its scanner sits: those of {} are taken",
                        robot_.name));
    readings_.warn(name_, recording_.warnings);
    settle_beams(recording_.log, name_, recording_.warnings);
    LaserScanner& laser = recording_.log.laser();
    laser.range_max_m = find_range_max_m(recording_.log.scans, robot_.range_max_m);
    replace_infinite_readings(recording_.log);
    laser.T_vehicle_laser = options.T_vehicle_laser.value_or(robot_.T_vehicle_laser);
    recording_.has_mounting = options.T_vehicle_laser.has_value();
    mend_clock(recording_.log, name_, recording_.warnings);
    const Problems problems = check_recording(recording_, LengthUnit::kMetre, name_);
    if (!problems.empty()) return problems;
    return std::move(recording_);
  }

 private:
  void warn(long line, std::string what) { recording_.warnings.push_back({{name_, line}, std::move(what)}); }

  const CountedRobot& robot_;
  std::string name_;
  LaserRecording recording_;
  std::optional<Counts> last_;
  Pose2 T_odom_vehicle_;
  ReadingCounts readings_;
  LeftOutLines left_out_;
};

std::vector<double> read_rest(FieldReader& fields, std::string_view line) {
  std::vector<double> numbers;
  numbers.reserve(std::min(kReadingsMax + 1, line.size() / 2));
  const std::size_t count = FieldReader(fields).remaining(kReadingsMax);
  for (std::size_t i = 0; i < count && fields.ok(); ++i)
    numbers.push_back(fields.number("reading", kNumberMax));
  return numbers;
}

constexpr std::size_t kCoreslamHead = 24;  ///< numbers before the readings
constexpr std::size_t kUrgReadings = 600;  ///< a URG-04LX gives 682 or 683

std::size_t numbers_in(std::string_view line) {
  FieldReader fields(line);
  std::size_t count = 0;
  for (std::string_view word = fields.word(); !word.empty(); word = fields.word(), ++count) {
    if (!parse_number(word)) return 0;
  }
  return count;
}

/// A record of the Lego robot, by its time.
struct LegoRecord {
  double stamp_s = 0;
  long line = 0;
  std::optional<Counts> counts;  ///< none: a scan
  std::vector<double> readings_mm = {};
};

/// M: the time in ms, then position and three more of the left motor, of the right one, of a third.
/// S: the time in ms, perhaps the number of readings, the readings.
std::optional<LegoRecord> read_lego_record(std::string_view line, long number, CountedLog& log) {
  FieldReader fields(line);
  const std::string_view kind = fields.word();
  if (kind != "M" && kind != "S") return std::nullopt;
  LegoRecord record{
      .stamp_s = fields.number("time", kNumberMax) / 1000, .line = number, .counts = std::nullopt};
  std::vector<double> numbers = read_rest(fields, line);
  if (kind == "M" && numbers.size() < 5) fields.fail("has too few numbers for a record of motors");
  const bool begins_with_count =
      !numbers.empty() && numbers.front() == static_cast<double>(numbers.size() - 1);
  if (kind == "S" && begins_with_count) numbers.erase(numbers.begin());
  if (kind == "S" && numbers.size() < 2) fields.fail("has too few readings");
  if (!fields.ok()) return log.leave_out(number, fields.failure()), std::nullopt;
  if (kind == "M") {
    record.counts = Counts{numbers[0], numbers[4]};
  } else {
    record.readings_mm = std::move(numbers);
  }
  return record;
}

bool has_record(std::string_view text, std::string_view kind, std::size_t numbers_min) {
  constexpr int kLinesLookedAt = 100;
  for (int i = 0; i < kLinesLookedAt && !text.empty(); ++i) {
    const bool is_whole = text.find('\n') != std::string_view::npos;
    const std::string_view line = take_line(text);
    if (is_whole && line.starts_with(kind) && numbers_in(line.substr(kind.size())) >= numbers_min)
      return true;
  }
  return false;
}

}  // namespace

Result<LaserRecording> parse_coreslam_log(std::string_view text, const std::string& name,
                                          const RecordingOptions& options) {
  CountedLog log(kRover, name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    if (trimmed(line).empty()) continue;
    FieldReader fields(line);
    const double stamp_s = fields.number("time", 1e17) * 1e-6;
    std::vector<double> numbers = read_rest(fields, line);
    if (fields.ok() && numbers.size() < kCoreslamHead + 1) fields.fail("has too few numbers for a scan");
    if (!fields.ok()) {
      log.leave_out(line_number, fields.failure());
      continue;
    }
    log.add_counts(stamp_s, {numbers[1], numbers[2]}, line_number);
    numbers.erase(numbers.begin(), numbers.begin() + kCoreslamHead - 1);
    log.add_scan(stamp_s, numbers, line_number);
  }
  return std::move(log).finish(options);
}

Result<LaserRecording> parse_lego_log(std::span<const std::string> texts, const std::string& name,
                                      const RecordingOptions& options) {
  CountedLog log(kLego, name);
  std::vector<LegoRecord> records;
  for (const std::string& bytes : texts) {
    std::string_view text = bytes;
    for (long line_number = 1; !text.empty(); ++line_number) {
      if (auto record = read_lego_record(take_line(text), line_number, log))
        records.push_back(std::move(*record));
    }
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const LegoRecord& a, const LegoRecord& b) { return a.stamp_s < b.stamp_s; });
  for (const LegoRecord& record : records) {
    if (record.counts)
      log.add_counts(record.stamp_s, *record.counts, record.line);
    else
      log.add_scan(record.stamp_s, record.readings_mm, record.line);
  }
  return std::move(log).finish(options);
}

bool begins_coreslam_log(std::string_view head) {
  const std::size_t first = numbers_in(take_line(head));
  if (first < kCoreslamHead + kUrgReadings || first > kCoreslamHead + kReadingsMax) return false;
  return head.find('\n') == std::string_view::npos || numbers_in(take_line(head)) == first;
}

bool begins_lego_log(std::string_view head) {
  constexpr std::size_t kMotorNumbers = 13;
  return has_lego_scans(head) || has_record(head, "M ", kMotorNumbers);
}

bool has_lego_scans(std::string_view text) {
  return has_record(text, "S ", kUrgReadings);
}

}  // namespace aisle
