#include "aisle/formats/logs/bee_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "field_reader.hpp"
#include "logs/carmen_beam_angles.hpp"
#include "logs/carmen_range.hpp"
#include "logs/left_out_lines.hpp"
#include "logs/length_unit.hpp"
#include "logs/mended_clock.hpp"
#include "logs/recorded_mounting.hpp"
#include "logs/recording_checks.hpp"
#include "logs/scan_beams.hpp"
#include "logs/scan_readings.hpp"

namespace aisle {
namespace {

constexpr double kUnit_m = metres_per(LengthUnit::kCentimetre);
constexpr std::size_t kBeeReadingsMin = 10, kBeeReadingsMax = 10000;
constexpr std::size_t kBesideReadings = 7;  ///< numbers of a record L that are none: two poses and the stamp
constexpr double kBeeStampMax_s = 1e11;

class BeeLogParser {
 public:
  explicit BeeLogParser(const std::string& name) : name_(name) {}

  Result<LaserRecording> parse(std::string_view text, const RecordingOptions& options) {
    for (long line = 1; !text.empty(); ++line) read_line(take_line(text), line);
    return finish(options);
  }

 private:
  void read_line(std::string_view line, long number) {
    FieldReader fields(line);
    const std::string_view kind = fields.word();
    if (kind.empty() || kind == "O") return;
    if (kind != "L") fields.fail(fmt::format("'{}' is not a record L or O", printable(kind)));
    if (fields.ok()) read_scan(fields, number);
    if (!fields.ok()) left_out_.add(number, fields.failure());
  }

  void read_scan(FieldReader& fields, long line) {
    const std::size_t numbers = FieldReader(fields).remaining(kBeeReadingsMax + kBesideReadings);
    if (numbers < kBeeReadingsMin + kBesideReadings) return fields.fail("has too few numbers for a scan");
    const Pose2 T_odom_vehicle = fields.pose("robot pose", kUnit_m);
    const Pose2 T_odom_laser = fields.pose("laser pose", kUnit_m);
    LaserScan scan;
    scan.line = line;
    scan.ranges_m.reserve(numbers - kBesideReadings);
    for (std::size_t i = kBesideReadings; i < numbers && fields.ok(); ++i)
      scan.ranges_m.push_back(readings_.kept(kUnit_m * fields.any_number("reading"), line));
    scan.stamp_s = fields.number("stamp", kBeeStampMax_s);
    if (!fields.ok()) return;
    scan.beams = flaser_beams(scan.ranges_m.size(), std::nullopt);
    mounting_.add(T_odom_vehicle, T_odom_laser);
    recording_.log.odometry.push_back({scan.stamp_s, T_odom_vehicle, line});
    scan.odometry_known = recording_.log.odometry.size();
    recording_.log.scans.push_back(std::move(scan));
  }

  Result<LaserRecording> finish(const RecordingOptions& options) {
    LaserLog& log = recording_.log;
    if (log.scans.empty()) return Problem{{name_}, "has no scan that can be read"};
    left_out_.warn(name_, recording_.warnings);
    readings_.warn(name_, recording_.warnings);
    settle_beams(log, name_, recording_.warnings);
    log.laser().range_max_m = find_range_max_m(log.scans, 0);
    replace_infinite_readings(log);
    const auto T_vehicle_laser = options.T_vehicle_laser ? options.T_vehicle_laser : mounting_.agreed();
    recording_.has_mounting = T_vehicle_laser.has_value();
    log.laser().T_vehicle_laser = T_vehicle_laser.value_or(Pose2{});
    mend_clock(log, name_, recording_.warnings);
    if (Problems problems = check_recording(recording_, LengthUnit::kCentimetre, name_); !problems.empty())
      return problems;
    return std::move(recording_);
  }

  std::string name_;
  LaserRecording recording_;
  RecordedMounting mounting_;
  ReadingCounts readings_;
  LeftOutLines left_out_;
};

}  // namespace

Result<LaserRecording> parse_bee_log(std::string_view text, const std::string& name,
                                     const RecordingOptions& options) {
  return BeeLogParser(name).parse(text, options);
}

bool begins_bee_log(std::string_view head) {
  constexpr int kLinesLookedAt = 20;
  constexpr std::size_t kOdometryNumbers = 4;
  for (int i = 0; i < kLinesLookedAt && !head.empty(); ++i) {
    const bool is_whole = head.find('\n') != std::string_view::npos;
    FieldReader fields(take_line(head));
    const std::string_view kind = fields.word();
    const std::size_t numbers = FieldReader(fields).remaining(kBeeReadingsMax + kBesideReadings);
    if (kind == "O" && numbers == kOdometryNumbers) continue;
    if (kind != "L" || !is_whole || numbers < kBeeReadingsMin + kBesideReadings) return false;
    for (std::size_t k = 0; k < numbers && fields.ok(); ++k) fields.any_number("number");
    return fields.ok();
  }
  return false;
}

}  // namespace aisle
