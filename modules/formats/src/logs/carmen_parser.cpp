#include "logs/carmen_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "logs/carmen_beam_angles.hpp"
#include "logs/carmen_range.hpp"
#include "logs/length_unit.hpp"
#include "logs/mended_clock.hpp"
#include "logs/recorded_mounting.hpp"
#include "logs/recording_checks.hpp"
#include "logs/scan_beams.hpp"

namespace aisle {
namespace {

/// Whether a file that ends with this word lost the rest of a message.
bool is_cut_off_name(std::string_view word) {
  constexpr std::array<std::string_view, 5> kNames = {"FLASER", "RAWLASER1", "ROBOTLASER1", "ODOM", "PARAM"};
  return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
    return !word.empty() && word.size() < name.size() && name.starts_with(word);
  });
}

}  // namespace

CarmenParser::CarmenParser(const std::string& name, const RecordingOptions& options)
    : name_(name), options_(options), metres_per_unit_(metres_per(options.unit)), unreadable_(name) {}

Result<LaserRecording> CarmenParser::parse(std::string_view text) {
  while (!text.empty()) {
    ++line_;
    const std::string_view line = take_line(text);
    read_line(line, text.empty());
  }
  if (log().scans.empty() && unreadable_.empty()) {
    return Problem{{name_}, "has no scans: no line begins with FLASER, RAWLASER1 or ROBOTLASER1"};
  }
  if (log().scans.empty() || !is_mostly_readable()) return unreadable_.take();
  warn_of_lines();
  settle_scanner();
  mend_clock(log(), name_, recording_.warnings);
  if (const std::optional<long> line = corrected_.first_line()) {
    recording_.warnings.push_back(
        {{name_, *line},
         "the poses of the scans are not those of the ODOM lines: a mapping program "
         "has corrected them; they are taken as odometry"});
  }
  const Problems problems = check_recording(recording_, options_.unit, name_);
  if (!problems.empty()) return problems;
  return std::move(recording_);
}

/// A crash of the recording computer leaves NUL bytes, within a line or before the next one: what is whole on
/// either side is read.
void CarmenParser::read_line(std::string_view line, bool is_last) {
  std::string failure;
  if (line.find('\0') != std::string_view::npos) failure = "holds NUL bytes";
  bool begins_line = true;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find('\0'), line.size());
    FieldReader fields(line.substr(0, end));
    if (is_last && end == line.size() && is_cut_off_name(line)) fields.fail("the file is cut off here");
    read_message(fields, begins_line);
    if (!fields.ok()) failure = fields.failure();
    line.remove_prefix(std::min(end + 1, line.size()));
    begins_line = false;
  }
  if (failure.empty()) return;
  if (damaged_lines_.count == 0) first_failure_ = failure;
  damaged_lines_.add(line_);
  unreadable_.add(line_, std::move(failure));
}

void CarmenParser::read_message(FieldReader& fields, bool begins_line) {
  const std::string_view word = fields.word();
  if (word.empty() || word.front() == '#') return;
  if (word == "FLASER") return take_scan(fields, ScanKind::kFlaser);
  if (word == "RAWLASER1") return take_scan(fields, ScanKind::kRawLaser);
  if (word == "ROBOTLASER1") return take_scan(fields, ScanKind::kRobotLaser);
  if (word == "ODOM") return take_odometry(fields);
  if (word == "PARAM") return read_param(fields, metres_per_unit_, params_);
  if (!begins_line || is_other_carmen_message(word)) return;
  if (unknown_lines_.count == 0) first_unknown_ = printable(word);
  unknown_lines_.add(line_);
}

void CarmenParser::take_scan(FieldReader& fields, ScanKind kind) {
  if (kind_ && kind != *kind_) return;
  ScanMessage scan = kind == ScanKind::kFlaser     ? read_flaser(fields, metres_per_unit_)
                     : kind == ScanKind::kRawLaser ? read_rawlaser(fields, metres_per_unit_)
                                                   : read_robotlaser(fields, metres_per_unit_);
  if (fields.ok()) check_whole(fields, scan.stamp, after_scan_stamp_);
  ++messages_;
  unreadable_messages_ += !fields.ok();
  if (!fields.ok()) return;
  if (!kind_ && scan.T_odom_vehicle) log().odometry.clear();  // the scans have their own
  kind_ = kind;
  add_scan(std::move(scan));
}

void CarmenParser::add_scan(ScanMessage message) {
  if (message.T_odom_vehicle) {
    mounting_.add(*message.T_odom_vehicle, *message.T_odom_laser);
    if (T_odom_) corrected_.add(*T_odom_, *message.T_odom_vehicle, line_);
    add_odometry({*message.T_odom_vehicle, message.stamp});
  }
  if (log().scans.empty()) announced_range_max_m_ = message.maximum_range_m;
  LaserScan scan;
  scan.stamp_s = message.stamp.stamp_s;
  scan.ranges_m.reserve(message.readings_m.size());
  for (const double reading_m : message.readings_m) scan.ranges_m.push_back(readings_.kept(reading_m, line_));
  scan.odometry_known = log().odometry.size();
  scan.beams = message.beams;
  scan.line = line_;
  if (!message.fits_field_of_view) wrong_resolution_.add(line_);
  if (message.beams && message.beams->angle_step_rad < 0) make_counter_clockwise(scan);
  log().scans.push_back(std::move(scan));
}

void CarmenParser::check_whole(FieldReader& fields, const StampFields& stamp,
                               std::optional<std::size_t>& usual) {
  if (!usual) usual = stamp.after_stamp;
  if (stamp.after_stamp < *usual) {
    fields.fail("the line ends before its host or logger timestamp; it seems to be cut off");
  }
}

void CarmenParser::take_odometry(FieldReader& fields) {
  const OdometryMessage odometry = read_odometry(fields, metres_per_unit_);
  if (fields.ok()) check_whole(fields, odometry.stamp, after_odometry_stamp_);
  ++messages_;
  unreadable_messages_ += !fields.ok();
  if (!fields.ok()) return;
  T_odom_ = odometry.T_odom_vehicle;
  const bool scans_have_their_own = kind_ && *kind_ != ScanKind::kRawLaser;
  if (!scans_have_their_own) add_odometry(odometry);
}

void CarmenParser::add_odometry(const OdometryMessage& odometry) {
  log().odometry.push_back({odometry.stamp.stamp_s, odometry.T_odom_vehicle, line_});
}

bool CarmenParser::is_mostly_readable() const {
  return 2 * unreadable_messages_ <= messages_;
}

void CarmenParser::settle_scanner() {
  if (kind_ == ScanKind::kFlaser) fill_in_flaser_beams();
  settle_beams(log(), name_, recording_.warnings);
  log().laser().range_max_m =
      find_range_max_m(log().scans, params_.maximum_range_m.value_or(announced_range_max_m_));
  replace_infinite_readings(log());
  settle_mounting();
}

void CarmenParser::fill_in_flaser_beams() {
  const std::size_t usual_count = usual_reading_count(log(), 0);
  const ScanBeams usual = flaser_beams(usual_count, params_.resolution_deg);
  if (!params_.resolution_deg) recording_.other_beams = other_flaser_beams(usual_count);
  for (LaserScan& scan : log().scans) {
    scan.beams = flaser_beams_like(usual, usual_count, scan.ranges_m.size(), params_.resolution_deg);
  }
}

void CarmenParser::settle_mounting() {
  std::optional<Pose2> T_vehicle_laser = options_.T_vehicle_laser;
  if (!T_vehicle_laser) T_vehicle_laser = params_.mounting();
  recording_.has_mounting = T_vehicle_laser.has_value();
  if (!T_vehicle_laser) {
    // Two equal poses say that one was written twice, not that the scanner is at the vehicle's origin.
    T_vehicle_laser = mounting_.agreed().value_or(Pose2{});
    recording_.has_mounting = is_off_origin(*T_vehicle_laser);
  }
  log().laser().T_vehicle_laser = *T_vehicle_laser;
}

void CarmenParser::warn_of_lines() {
  readings_.warn(name_, recording_.warnings);
  warn(damaged_lines_,
       fmt::format("{}; damaged lines: {}, whole messages are used", first_failure_, damaged_lines_.count));
  warn(unknown_lines_, fmt::format("'{}' is not a CARMEN message; {} such lines were skipped", first_unknown_,
                                   unknown_lines_.count));
  warn(wrong_resolution_,
       fmt::format("the angular resolution does not fit the field of view in {} scans, first here: the "
                   "readings are taken to share the field of view",
                   wrong_resolution_.count));
}

void CarmenParser::warn(const Occurrences& where, std::string what) {
  if (where.count > 0) recording_.warnings.push_back({{name_, where.first_line}, std::move(what)});
}

}  // namespace aisle
