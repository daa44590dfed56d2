#include "aisle/formats/logs/carmen_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/formats/whole_file.hpp"
#include "logs/carmen_messages.hpp"
#include "logs/carmen_range.hpp"
#include "logs/mended_clock.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

enum class ScanKind { kFlaser, kRawLaser, kRobotLaser };

/// The laser's mounting according to the two poses of each scan, as long as all scans agree. (They disagree
/// where the laser's pose was corrected afterwards, or the two were not read at the same time.)
class RecordedMounting {
 public:
  void add(const Pose2& T_odom_vehicle, const Pose2& T_odom_laser) {
    const Pose2 T_vehicle_laser = between(T_odom_vehicle, T_odom_laser);
    if (!first_) first_ = T_vehicle_laser;
    const Pose2 change = between(*first_, T_vehicle_laser);
    all_agree_ = all_agree_ && change.position().norm() < 0.01 && std::abs(change.theta) < 0.5 * kDegree;
  }

  std::optional<Pose2> agreed() const { return all_agree_ ? first_ : std::nullopt; }

 private:
  std::optional<Pose2> first_;
  bool all_agree_ = true;
};

/// Whether a file that ends with this word lost the rest of a message.
bool is_cut_off_name(std::string_view word) {
  constexpr std::array<std::string_view, 5> kNames = {"FLASER", "RAWLASER1", "ROBOTLASER1", "ODOM", "PARAM"};
  return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
    return !word.empty() && word.size() < name.size() && name.starts_with(word);
  });
}

ScanMessage read_scan(FieldReader& fields, ScanKind kind, double metres_per_unit) {
  switch (kind) {
    case ScanKind::kFlaser:
      return read_flaser(fields, metres_per_unit);
    case ScanKind::kRawLaser:
      return read_rawlaser(fields, metres_per_unit);
    case ScanKind::kRobotLaser:
      return read_robotlaser(fields, metres_per_unit);
  }
  return {};
}

class CarmenParser {
 public:
  CarmenParser(const std::string& name, const CarmenOptions& options)
      : name_(name),
        options_(options),
        metres_per_unit_(options.unit == LengthUnit::kCentimetre ? 0.01 : 1),
        problems_(name) {}

  Result<CarmenLog> parse(std::string_view text);

 private:
  void read_message(FieldReader& fields);
  void take(FieldReader& fields, ScanKind kind);
  void check_like_first(FieldReader& fields, const ScanMessage& scan);
  void check_whole(FieldReader& fields, const StampFields& stamp, std::optional<std::size_t>& usual);
  void take_odometry(FieldReader& fields);
  void add_odometry(const OdometryMessage& odometry);
  void forget_odometry();
  void count_unknown(std::string_view word);

  void settle_scanner();
  void settle_clock();
  void check_unit();
  void check_leaps();
  void warn(long line, std::string what) {
    warnings_.push_back(to_string(Problem{{name_, line}, std::move(what)}));
  }

  std::string name_;
  CarmenOptions options_;
  double metres_per_unit_;
  ProblemList problems_;
  std::vector<std::string> warnings_;

  long line_ = 0;
  std::optional<ScanKind> kind_;  ///< of the first scan; other kinds repeat the same scans
  LaserLog log_;
  std::optional<BeamAngles> beam_angles_;
  double announced_range_max_m_ = 0;
  CarmenParams params_;
  RecordedMounting mounting_;
  std::vector<RecordedStamp> scan_stamps_, odometry_stamps_;
  std::optional<std::size_t> after_scan_stamp_, after_odometry_stamp_;
  std::size_t unknown_count_ = 0;
  long first_unknown_line_ = 0;
  std::string first_unknown_;
};

Result<CarmenLog> CarmenParser::parse(std::string_view text) {
  if (text.empty()) return Problem{{name_}, "is empty"};
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    return Problem{{name_, line}, "is binary data, not a text log"};
  }
  while (!text.empty()) {
    ++line_;
    const std::string_view line = take_line(text);
    FieldReader fields(line);
    if (text.empty() && is_cut_off_name(line)) fields.fail("the file is cut off here");
    read_message(fields);
    if (!fields.ok()) problems_.add(line_, fields.failure());
  }
  if (kind_ == ScanKind::kRawLaser && log_.odometry.empty()) {
    problems_.add(0, "has RAWLASER1 scans but no ODOM lines to tell their odometry");
  }
  if (!problems_.empty()) return problems_.take();
  if (log_.scans.empty()) {
    return Problem{{name_}, "has no scans: no line begins with FLASER, RAWLASER1 or ROBOTLASER1"};
  }
  settle_scanner();
  settle_clock();
  check_unit();
  check_leaps();
  if (unknown_count_ > 0) {
    warn(first_unknown_line_, fmt::format("'{}' is not a CARMEN message; {} such lines were skipped",
                                          first_unknown_, unknown_count_));
  }
  return CarmenLog{std::move(log_), std::move(warnings_)};
}

void CarmenParser::read_message(FieldReader& fields) {
  const std::string_view word = fields.word();
  if (word.empty() || word.front() == '#') return;
  if (word == "FLASER") return take(fields, ScanKind::kFlaser);
  if (word == "RAWLASER1") return take(fields, ScanKind::kRawLaser);
  if (word == "ROBOTLASER1") return take(fields, ScanKind::kRobotLaser);
  if (word == "ODOM") return take_odometry(fields);
  if (word == "PARAM") return read_param(fields, metres_per_unit_, params_);
  if (!is_other_carmen_message(word)) count_unknown(word);
}

void CarmenParser::take(FieldReader& fields, ScanKind kind) {
  if (!kind_) kind_ = kind;
  if (kind != *kind_) return;
  ScanMessage scan = read_scan(fields, kind, metres_per_unit_);
  if (fields.ok()) check_whole(fields, scan.stamp, after_scan_stamp_);
  if (fields.ok()) check_like_first(fields, scan);
  if (!fields.ok()) return;
  if (log_.scans.empty()) {
    beam_angles_ = scan.angles;
    announced_range_max_m_ = scan.maximum_range_m;
    if (scan.T_odom_vehicle) forget_odometry();
  }
  if (scan.T_odom_vehicle) {
    mounting_.add(*scan.T_odom_vehicle, *scan.T_odom_laser);
    add_odometry({*scan.T_odom_vehicle, scan.stamp});
  }
  scan_stamps_.push_back({scan.stamp.stamp_s, line_});
  log_.scans.push_back({scan.stamp.stamp_s, 0, std::move(scan.ranges_m), log_.odometry.size()});
}

void CarmenParser::check_whole(FieldReader& fields, const StampFields& stamp,
                               std::optional<std::size_t>& usual) {
  if (!usual) usual = stamp.after_stamp;
  if (stamp.after_stamp < *usual) {
    fields.fail("the line ends before its host or logger timestamp; it seems to be cut off");
  }
}

void CarmenParser::check_like_first(FieldReader& fields, const ScanMessage& scan) {
  if (log_.scans.empty()) return;
  const std::size_t beams = log_.scans.front().ranges_m.size();
  if (scan.ranges_m.size() != beams) {
    fields.fail(fmt::format("has {} readings, the first scan (line {}) has {}", scan.ranges_m.size(),
                            scan_stamps_.front().line, beams));
  }
  constexpr double kSameAngle_rad = 1e-4;
  if (beam_angles_ &&
      (std::abs(scan.angles->first_angle_rad - beam_angles_->first_angle_rad) > kSameAngle_rad ||
       std::abs(scan.angles->angle_step_rad - beam_angles_->angle_step_rad) > kSameAngle_rad)) {
    fields.fail(
        fmt::format("has different beam angles from the first scan (line {})", scan_stamps_.front().line));
  }
}

void CarmenParser::take_odometry(FieldReader& fields) {
  const OdometryMessage odometry = read_odometry(fields, metres_per_unit_);
  if (fields.ok()) check_whole(fields, odometry.stamp, after_odometry_stamp_);
  const bool scans_have_their_own = !log_.scans.empty() && *kind_ != ScanKind::kRawLaser;
  if (fields.ok() && !scans_have_their_own) add_odometry(odometry);
}

void CarmenParser::add_odometry(const OdometryMessage& odometry) {
  odometry_stamps_.push_back({odometry.stamp.stamp_s, line_});
  log_.odometry.push_back({0, odometry.T_odom_vehicle});
}

void CarmenParser::forget_odometry() {
  odometry_stamps_.clear();
  log_.odometry.clear();
}

void CarmenParser::settle_scanner() {
  LaserScanner& laser = log_.laser();
  const BeamAngles angles =
      beam_angles_.value_or(flaser_beam_angles(log_.scans.front().ranges_m.size(), params_.resolution_deg));
  laser.first_angle_rad = angles.first_angle_rad;
  laser.angle_step_rad = angles.angle_step_rad;
  laser.range_max_m = find_range_max_m(log_.scans, params_.maximum_range_m.value_or(announced_range_max_m_));
  std::optional<Pose2> T_vehicle_laser = options_.T_vehicle_laser;
  if (!T_vehicle_laser) T_vehicle_laser = params_.mounting();
  if (!T_vehicle_laser) T_vehicle_laser = mounting_.agreed();
  laser.T_vehicle_laser = T_vehicle_laser.value_or(Pose2{});
}

void CarmenParser::settle_clock() {
  const ClockRepair repair = mend_clock(log_, scan_stamps_, odometry_stamps_);
  if (repair.places == 0) return;
  warn(repair.first_line,
       fmt::format(
           "stamps go back, jump or stand still at {} places, first here; scans are taken in file order{}",
           repair.places,
           repair.by_nominal_step ? fmt::format(", {} s from one line to the next", kNominalStep_s) : ""));
}

void CarmenParser::check_unit() {
  const double median_m = median_reading_m(log_);
  if (options_.unit == LengthUnit::kMetre && median_m > 60) {
    warn(0, fmt::format("half of the readings are above {:.0f} m: if they are centimetres, say --units cm",
                        median_m));
  }
  if (options_.unit == LengthUnit::kCentimetre && median_m > 0 && median_m < 0.3) {
    warn(0, fmt::format("half of the readings are below {:.3f} m: if they are metres, leave out --units cm",
                        median_m));
  }
}

void CarmenParser::check_leaps() {
  constexpr double kLeap_m = 20;  // no vehicle drives that far from one line to the next
  std::size_t count = 0, first = 0;
  double first_m = 0;
  for (std::size_t i = 1; i < log_.odometry.size(); ++i) {
    const Vec2 from = log_.odometry[i - 1].T_odom_vehicle.position();
    const double step_m = (log_.odometry[i].T_odom_vehicle.position() - from).norm();
    if (step_m <= kLeap_m || count++ > 0) continue;
    first = i;
    first_m = step_m;
  }
  if (count == 0) return;
  warn(odometry_stamps_[first].line,
       fmt::format("the odometry jumps by {:.0f} m from the pose before; {} such jumps in the log", first_m,
                   count));
}

void CarmenParser::count_unknown(std::string_view word) {
  if (unknown_count_++ > 0) return;
  first_unknown_line_ = line_;
  first_unknown_ = printable(word);
}

}  // namespace

Result<CarmenLog> parse_carmen_log(std::string_view text, const std::string& name,
                                   const CarmenOptions& options) {
  return CarmenParser(name, options).parse(text);
}

Result<CarmenLog> read_carmen_log(const std::filesystem::path& path, const CarmenOptions& options) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_carmen_log(*text, path.string(), options);
}

}  // namespace aisle
