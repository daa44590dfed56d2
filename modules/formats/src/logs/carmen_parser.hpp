#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"
#include "logs/carmen_messages.hpp"
#include "logs/corrected_poses.hpp"
#include "logs/occurrences.hpp"
#include "logs/recorded_mounting.hpp"
#include "logs/scan_readings.hpp"
#include "problem_list.hpp"

namespace aisle {

/// Reads one CARMEN log: its lines first, then what follows from all of them together.
class CarmenParser {
 public:
  CarmenParser(const std::string& name, const RecordingOptions& options);

  Result<LaserRecording> parse(std::string_view text);

 private:
  enum class ScanKind { kFlaser, kRawLaser, kRobotLaser };

  void read_line(std::string_view line, bool is_last);
  void read_message(FieldReader& fields, bool begins_line);
  void take_scan(FieldReader& fields, ScanKind kind);
  void add_scan(ScanMessage scan);
  void take_odometry(FieldReader& fields);
  void add_odometry(const OdometryMessage& odometry);
  void check_whole(FieldReader& fields, const StampFields& stamp, std::optional<std::size_t>& usual);
  bool is_mostly_readable() const;

  void settle_scanner();
  void fill_in_flaser_beams();
  void settle_mounting();
  void warn_of_lines();
  void warn(const Occurrences& where, std::string what);

  LaserLog& log() { return recording_.log; }

  std::string name_;
  RecordingOptions options_;
  double metres_per_unit_;
  ProblemList unreadable_;
  LaserRecording recording_;

  long line_ = 0;
  std::optional<ScanKind> kind_;  ///< of the first scan; other kinds repeat the same scans
  std::size_t messages_ = 0, unreadable_messages_ = 0;  ///< scans of the kind that counts, and ODOM lines
  double announced_range_max_m_ = 0;
  CarmenParams params_;
  RecordedMounting mounting_;
  std::optional<Pose2> T_odom_;  ///< of the latest ODOM line
  CorrectedPoses corrected_;
  std::optional<std::size_t> after_scan_stamp_, after_odometry_stamp_;

  ReadingCounts readings_;
  Occurrences damaged_lines_, wrong_resolution_, unknown_lines_;
  std::string first_unknown_, first_failure_;
};

}  // namespace aisle
