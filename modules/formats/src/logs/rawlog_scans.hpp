#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/formats/logs/laser_recording.hpp"
#include "logs/mrpt_objects.hpp"
#include "logs/occurrences.hpp"
#include "logs/scan_readings.hpp"

namespace aisle {

/// The scans of a rawlog, by scanner: a label at one place.
class RawlogScans {
 public:
  explicit RawlogScans(LaserLog& log) : log_(log) { log_.lasers.clear(); }

  void add(const MrptScan& scan, long object);
  /// What follows from all scans together: ranges, mountings, and what looks wrong.
  void finish(const RecordingOptions& options, const std::string& name, LaserRecording& recording);

 private:
  struct Scanner {
    std::string label;
    Pose2 T_vehicle_laser;
    double announced_range_max_m;
  };
  std::size_t scanner_of(const MrptScan& scan);
  void count_validity(const MrptScan& scan);
  void add_readings(const MrptScan& scan, long object, LaserScan& to);
  void settle_ranges();
  void apply_validity();
  void warn_of_contents(const std::string& name, Problems& warnings) const;

  LaserLog& log_;
  std::vector<Scanner> scanners_;
  std::vector<std::string> validity_;  ///< one a scan of the log, in the order of its readings
  std::size_t in_range_ = 0, valid_in_range_ = 0;
  ReadingCounts readings_;
  Occurrences tilted_, unusable_, understated_;
  ScanBeams stated_;  ///< of the first understated scan
};

}  // namespace aisle
