#include "aisle/formats/logs/rawlog.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "logs/mended_clock.hpp"
#include "logs/mrpt_objects.hpp"
#include "logs/mrpt_stream.hpp"
#include "logs/occurrences.hpp"
#include "logs/rawlog_odometry.hpp"
#include "logs/rawlog_scans.hpp"
#include "logs/recording_checks.hpp"

namespace aisle {
namespace {

/// The classes of a rawlog that are read, with their latest versions.
constexpr int kFrameVersion = 2;
constexpr int kCollectionVersion = 0;
constexpr int kScanVersion = 7;
constexpr int kOdometryVersion = 2;
constexpr int kMovementVersion = 7;

class RawlogParser {
 public:
  RawlogParser(std::string_view bytes, const std::string& name, const RecordingOptions& options)
      : stream_(bytes), name_(name), options_(options), scans_(recording_.log), odometry_(recording_.log) {}

  Result<LaserRecording> parse();

 private:
  void read_record();
  void read_contents(const MrptHeader& header);
  bool is_known_version(const MrptHeader& header, int latest);
  void skip_record(const MrptHeader& header);
  void recover();
  Result<LaserRecording> finish();
  void warn(const Occurrences& where, std::string what) {
    if (where.count > 0) recording_.warnings.push_back({{name_, where.first_line}, std::move(what)});
  }

  MrptStream stream_;
  std::string name_;
  RecordingOptions options_;
  LaserRecording recording_;
  RawlogScans scans_;
  RawlogOdometry odometry_;
  long object_ = 0;
  Occurrences damaged_;
  std::string first_damage_;
  std::map<std::string, Occurrences, std::less<>> skipped_;
  Problems unknown_versions_;
};

Result<LaserRecording> RawlogParser::parse() {
  while (!stream_.is_at_end()) {
    ++object_;
    read_record();
    if (!stream_.ok()) recover();
    if (!unknown_versions_.empty()) return unknown_versions_;
  }
  return finish();
}

/// A frame or a collection is only a header before its objects, and an end after them.
void RawlogParser::read_record() {
  const MrptHeader header = stream_.read_header();
  if (stream_.ok()) read_contents(header);
  while (stream_.ok() && stream_.is_at_end_flag()) stream_.skip(1);
}

void RawlogParser::read_contents(const MrptHeader& header) {
  constexpr std::size_t kCount = 4, kFrameId = 4, kFrameStamp = 8;
  if (header.class_name == "CRawlog") {
    stream_.skip(kCount);
  } else if (header.class_name == "CSensoryFrame") {
    if (!is_known_version(header, kFrameVersion)) return;
    stream_.skip((header.version < 2 ? kFrameId : 0) + (header.version == 0 ? kFrameStamp : 0) + kCount);
  } else if (header.class_name == "CActionCollection") {
    if (!is_known_version(header, kCollectionVersion)) return;
    stream_.skip(kCount);
    odometry_.begin_collection();
  } else if (header.class_name == "CObservation2DRangeScan") {
    if (!is_known_version(header, kScanVersion)) return;
    const MrptScan scan = read_mrpt_scan(stream_, header.version);
    if (!stream_.ok()) return;
    odometry_.reach_scan(scan.stamp_s, object_);
    scans_.add(scan, object_);
  } else if (header.class_name == "CObservationOdometry") {
    if (!is_known_version(header, kOdometryVersion)) return;
    const MrptOdometry odometry = read_mrpt_odometry(stream_, header.version);
    if (stream_.ok()) odometry_.add(odometry, object_);
  } else if (header.class_name == "CActionRobotMovement2D") {
    if (!is_known_version(header, kMovementVersion)) return;
    const MrptMovement movement = read_mrpt_movement(stream_, header.version);
    if (stream_.ok()) odometry_.add(movement);
  } else {
    skip_record(header);
  }
}

bool RawlogParser::is_known_version(const MrptHeader& header, int latest) {
  if (header.version <= latest) return true;
  unknown_versions_.push_back({{name_, object_},
                               fmt::format("object {} of version {}: versions 0 to {} are read",
                                           header.class_name, header.version, latest)});
  return false;
}

/// The length of an object is not written; the next one is found by its header.
void RawlogParser::skip_record(const MrptHeader& header) {
  skipped_[fmt::format("{} (version {})", header.class_name, header.version)].add(object_);
  if (!stream_.seek_next_record()) stream_.skip_to_end();
}

void RawlogParser::recover() {
  if (damaged_.count == 0) first_damage_ = stream_.failure();
  damaged_.add(object_);
  const bool is_cut_off = stream_.is_cut_off();
  stream_.forget_failure();
  if (is_cut_off || !stream_.seek_next_record()) stream_.skip_to_end();
}

Result<LaserRecording> RawlogParser::finish() {
  if (recording_.log.scans.empty() || 2 * damaged_.count > static_cast<std::size_t>(object_)) {
    if (damaged_.count > 0) return Problem{{name_, damaged_.first_line}, "object: " + first_damage_};
    return Problem{{name_}, "has no usable scans: no CObservation2DRangeScan of a level scanner"};
  }
  warn(damaged_,
       fmt::format("object: {}; damaged objects: {}, whole ones are used", first_damage_, damaged_.count));
  for (const auto& [what, where] : skipped_) {
    warn(where, fmt::format("object: {} says nothing that is used; {} such objects were skipped", what,
                            where.count));
  }
  odometry_.finish();
  scans_.finish(options_, name_, recording_);
  mend_clock(recording_.log, name_, recording_.warnings);
  const Problems problems = check_recording(recording_, LengthUnit::kMetre, name_);
  if (!problems.empty()) return problems;
  return std::move(recording_);
}

}  // namespace

Result<LaserRecording> parse_rawlog(std::string_view bytes, const std::string& name,
                                    const RecordingOptions& options) {
  if (bytes.empty()) return Problem{{name}, "is empty"};
  return RawlogParser(bytes, name, options).parse();
}

}  // namespace aisle
