#include "aisle/formats/logs/laser_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "field_reader.hpp"
#include "logs/carmen_range.hpp"
#include "logs/laser_csv_columns.hpp"
#include "logs/mended_clock.hpp"
#include "logs/recording_checks.hpp"
#include "logs/scan_beams.hpp"
#include "logs/scan_readings.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

/// What comments say of the scanner.
struct CsvFacts {
  std::optional<double> first_angle_rad, angle_step_rad, range_max_m;
  std::optional<double> mount_x_m, mount_y_m, mount_heading_rad;

  void take(const CsvFact& fact) {
    if (fact.quantity == "first_angle") first_angle_rad = fact.value;
    if (fact.quantity == "angle_step") angle_step_rad = fact.value;
    if (fact.quantity == "range_max") range_max_m = fact.value;
    if (fact.quantity == "mount_x") mount_x_m = fact.value;
    if (fact.quantity == "mount_y") mount_y_m = fact.value;
    if (fact.quantity == "mount_heading") mount_heading_rad = fact.value;
  }
  std::optional<Pose2> mounting() const {
    if (!mount_x_m && !mount_y_m && !mount_heading_rad) return std::nullopt;
    return Pose2{mount_x_m.value_or(0), mount_y_m.value_or(0), mount_heading_rad.value_or(0)};
  }
};

class LaserCsvParser {
 public:
  LaserCsvParser(const std::string& name, const RecordingOptions& options)
      : name_(name), options_(options), problems_(name) {}

  Result<LaserRecording> parse(std::string_view text);

 private:
  void take_comment(std::string_view comment);
  void read_row();
  bool has_angles() const {
    return columns_.first_angle || (facts_.first_angle_rad && facts_.angle_step_rad);
  }
  double number(const CsvColumn& column, double limit);
  void add_odometry(double stamp_s);
  void add_scan(double stamp_s);
  void fail(const CsvColumn& column, const char* what) {
    problems_.add(line_, columns_.names[column.index],
                  fmt::format("'{}' {}", printable(cells_[column.index]), what));
  }
  Result<LaserRecording> finish();
  std::optional<Problem> settle_beams_of_scans();
  void warn_of_contents();
  void settle_laser();

  std::string name_;
  RecordingOptions options_;
  ProblemList problems_;
  LaserRecording recording_;
  CsvFacts facts_;
  CsvColumns columns_;
  long line_ = 0;
  std::vector<std::string_view> cells_;
  ReadingCounts readings_;
};

Result<LaserRecording> LaserCsvParser::parse(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  bool has_header = false;
  while (!text.empty()) {
    ++line_;
    const bool is_whole = text.find('\n') != std::string_view::npos;
    const std::string_view line = take_line(text);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) continue;
    if (line[first] == '#') {
      take_comment(line.substr(first + 1));
    } else if (!has_header) {
      const Result<CsvColumns> columns = read_csv_header(line, name_, line_);
      if (!columns) return columns.problems();
      columns_ = *columns;
      has_header = true;
    } else {
      split_csv_line(line, columns_.separator, cells_);
      if (!is_whole && cells_.size() < columns_.names.size()) {
        recording_.warnings.push_back({{name_, line_}, "the file is cut off in this row, which is left out"});
      } else {
        read_row();
      }
    }
  }
  if (!has_header) return Problem{{name_}, "has no header line that names the columns"};
  return finish();
}

void LaserCsvParser::take_comment(std::string_view comment) {
  const auto fact = read_csv_fact(comment);
  if (!fact) return;
  if (!fact->problem.empty()) return problems_.add(line_, fact->problem);
  facts_.take(*fact);
}

void LaserCsvParser::read_row() {
  if (cells_.size() != columns_.names.size()) {
    problems_.add(line_,
                  fmt::format("has {} columns, the header has {}", cells_.size(), columns_.names.size()));
    return;
  }
  constexpr double kStampMax_s = 1e11;
  const std::size_t problems_before = problems_.count();
  const double stamp_s = number(columns_.time, kStampMax_s);
  if (problems_.count() > problems_before) return;
  if (columns_.x) add_odometry(stamp_s);
  const bool has_readings = std::any_of(columns_.ranges.begin(), columns_.ranges.end(),
                                        [&](const CsvColumn& range) { return !cells_[range.index].empty(); });
  if (has_readings) add_scan(stamp_s);
}

/// A cell that must be a number of magnitude `limit` or less, in metres, radians or seconds.
double LaserCsvParser::number(const CsvColumn& column, double limit) {
  const auto value = parse_number(cells_[column.index]);
  const double scaled = value ? *value * column.scale : 0;
  if (!value) {
    fail(column, cells_[column.index].empty() ? "is empty" : "is not a number");
  } else if (!(std::abs(scaled) <= limit)) {
    fail(column, "is absurdly large or not finite");
  }
  return scaled;
}

void LaserCsvParser::add_odometry(double stamp_s) {
  constexpr double kPoseMax_m = 1e7, kHeadingMax_rad = 1e6;
  const Pose2 T_odom_vehicle = {number(*columns_.x, kPoseMax_m), number(*columns_.y, kPoseMax_m),
                                number(*columns_.heading, kHeadingMax_rad)};
  recording_.log.odometry.push_back({stamp_s, T_odom_vehicle, line_});
}

void LaserCsvParser::add_scan(double stamp_s) {
  LaserScan scan;
  scan.stamp_s = stamp_s;
  scan.line = line_;
  scan.odometry_known = recording_.log.odometry.size();
  scan.ranges_m.reserve(columns_.ranges.size());
  for (const CsvColumn& range : columns_.ranges) {
    // pandas writes NaN as an empty cell; scans with fewer readings end with such cells.
    const std::string_view cell = cells_[range.index];
    const auto value = cell.empty() ? 0.0 : parse_number(cell);
    if (!value) return fail(range, "is not a number");
    scan.ranges_m.push_back(readings_.kept(*value * range.scale, line_));
  }
  if (columns_.first_angle) {
    scan.beams = ScanBeams{number(*columns_.first_angle, 2.1 * kPi), number(*columns_.angle_step, kPi)};
  }
  recording_.log.scans.push_back(std::move(scan));
}

Result<LaserRecording> LaserCsvParser::finish() {
  if (!problems_.empty()) return problems_.take();
  if (recording_.log.scans.empty()) return Problem{{name_}, "has no row with readings"};
  if (!has_angles()) {
    return Problem{
        {name_},
        "does not say where the beams look: give columns first_angle_deg and angle_step_deg, or comments "
        "such as '# first_angle_deg: -90' and '# angle_step_deg: 1'"};
  }
  if (const auto problem = settle_beams_of_scans()) return *problem;
  warn_of_contents();
  settle_laser();
  mend_clock(recording_.log, name_, recording_.warnings);
  const Problems problems = check_recording(recording_, LengthUnit::kMetre, name_);
  if (!problems.empty()) return problems;
  return std::move(recording_);
}

std::optional<Problem> LaserCsvParser::settle_beams_of_scans() {
  for (LaserScan& scan : recording_.log.scans) {
    if (!scan.beams) scan.beams = ScanBeams{*facts_.first_angle_rad, *facts_.angle_step_rad};
    const double step_rad = scan.beams->angle_step_rad;
    const double swept_rad = std::abs(step_rad) * static_cast<double>(scan.ranges_m.size() - 1);
    if (step_rad == 0 || swept_rad > 2.1 * kPi) {
      return Problem{{name_, scan.line},
                     fmt::format("{} readings in steps of {:.4g} deg make no scan", scan.ranges_m.size(),
                                 to_degrees(step_rad))};
    }
    if (step_rad < 0) make_counter_clockwise(scan);
  }
  return std::nullopt;
}

void LaserCsvParser::warn_of_contents() {
  readings_.warn(name_, recording_.warnings);
  if (columns_.unknown.empty()) return;
  constexpr std::size_t kShown = 5;
  std::vector<std::string> shown = columns_.unknown;
  if (shown.size() > kShown) shown.resize(kShown);
  recording_.warnings.push_back({{name_},
                                 fmt::format("{} columns mean nothing here and are skipped: {}",
                                             columns_.unknown.size(), fmt::join(shown, ", "))});
}

void LaserCsvParser::settle_laser() {
  settle_beams(recording_.log, name_, recording_.warnings);
  LaserScanner& laser = recording_.log.laser();
  laser.range_max_m = find_range_max_m(recording_.log.scans, facts_.range_max_m.value_or(0));
  replace_infinite_readings(recording_.log);
  const std::optional<Pose2> T_vehicle_laser =
      options_.T_vehicle_laser ? options_.T_vehicle_laser : facts_.mounting();
  recording_.has_mounting = T_vehicle_laser.has_value();
  laser.T_vehicle_laser = T_vehicle_laser.value_or(Pose2{});
}

}  // namespace

Result<LaserRecording> parse_laser_csv(std::string_view text, const std::string& name,
                                       const RecordingOptions& options) {
  if (text.empty()) return Problem{{name}, "is empty"};
  return LaserCsvParser(name, options).parse(text);
}

}  // namespace aisle
