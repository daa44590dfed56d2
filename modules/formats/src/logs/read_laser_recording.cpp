#include "aisle/formats/logs/read_laser_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/bags/laser_bag.hpp"
#include "aisle/formats/file_contents.hpp"
#include "aisle/formats/logs/bee_log.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "aisle/formats/logs/counted_log.hpp"
#include "aisle/formats/logs/laser_csv.hpp"
#include "aisle/formats/logs/rawlog.hpp"
#include "logs/recording_kind.hpp"
#include "unpacked_file.hpp"

namespace aisle {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWhatIsRead =
    "recordings are CARMEN logs, MRPT rawlogs, CSV, CoreSLAM, Lego and Bee logs (each plain, gzip or bzip2), "
    "and ROS bags (.bag, .db3, .mcap)";

Problem other_kind(const fs::path& path, std::string_view head) {
  return {{path.string()}, fmt::format("is {}; {}", describe_contents(head), kWhatIsRead)};
}

/// All bytes of a file that begins like a recording. A pipe can be read only once, a file is looked at first.
Result<UnpackedFile> read_if_recording(const fs::path& path) {
  if (fs::is_regular_file(path)) {
    const Result<std::string> head = read_unpacked_head(path, kRecordingHead);
    if (!head) return head.problems();
    if (recording_kind(*head) == RecordingKind::kOther) return other_kind(path, *head);
  }
  return read_unpacked_file(path);
}

Result<LaserRecording> parse_of_kind(RecordingKind kind, std::string_view bytes, const fs::path& path,
                                     const RecordingOptions& options) {
  switch (kind) {
    case RecordingKind::kCarmen:
      return parse_carmen_log(bytes, path.string(), options);
    case RecordingKind::kRawlog:
      return parse_rawlog(bytes, path.string(), options);
    case RecordingKind::kCsv:
      return parse_laser_csv(bytes, path.string(), options);
    case RecordingKind::kCoreslam:
      return parse_coreslam_log(bytes, path.string(), options);
    case RecordingKind::kLego:
      return parse_lego_log({{std::string(bytes)}}, path.string(), options);
    case RecordingKind::kBee:
      return parse_bee_log(bytes, path.string(), options);
    case RecordingKind::kOther:
      break;
  }
  return other_kind(path, bytes.substr(0, kRecordingHead));
}

Result<LaserRecording> parse_recording(std::string_view bytes, const fs::path& path,
                                       const RecordingOptions& options) {
  const RecordingKind kind = recording_kind(bytes.substr(0, kRecordingHead));
  Result<LaserRecording> recording = parse_of_kind(kind, bytes, path, options);
  if (recording && kind != RecordingKind::kCarmen && options.unit != LengthUnit::kMetre) {
    recording->warnings.push_back({{path.string()}, "states its own units: --units says nothing of it"});
  }
  return recording;
}

/// Only bags have topics; to leave the odometry aside is possible in any recording.
Problems apply_choice(const RecordingOptions& options, const fs::path& path, LaserLog& log) {
  Problems problems;
  if (!options.scan_topic.empty()) problems.push_back({{path.string()}, "has no topics: --scan is for bags"});
  if (options.odometry == "none") {
    log.odometry.clear();
    for (LaserScan& scan : log.scans) scan.odometry_known = 0;
  } else if (!options.odometry.empty()) {
    problems.push_back({{path.string()}, "has no topics: of --odometry, only none is for logs"});
  }
  return problems;
}

Result<LaserRecording> with_choice(Result<LaserRecording> recording, const RecordingOptions& options,
                                   const fs::path& path) {
  if (!recording) return recording;
  if (Problems problems = apply_choice(options, path, recording->log); !problems.empty()) return problems;
  return recording;
}

Result<LaserRecording> read_recording_file(const fs::path& path, const RecordingOptions& options) {
  const Result<UnpackedFile> file = read_if_recording(path);
  if (!file) return file.problems();
  Result<LaserRecording> recording = with_choice(parse_recording(file->bytes, path, options), options, path);
  if (!recording) return recording;
  if (!file->damage.empty()) {
    recording->warnings.push_back({{path.string()}, file->damage + "; what comes before is used"});
  }
  return recording;
}

/// The texts of one run of the Lego robot: those with its scans and those with its motors. None if there is
/// not one run in these files.
std::optional<std::vector<std::string>> lego_run(const std::vector<fs::path>& files) {
  std::vector<std::string> texts;
  std::ptrdiff_t with_scans = 0;
  for (const fs::path& file : files) {
    auto text = read_unpacked_file(file);
    if (is_bag(file) || !text || !begins_lego_log(std::string_view(text->bytes).substr(0, kRecordingHead)))
      return std::nullopt;
    with_scans += has_lego_scans(text->bytes) ? 1 : 0;
    texts.push_back(std::move(text->bytes));
  }
  if (with_scans != 1) return std::nullopt;
  return texts;
}

Result<LaserRecording> read_recording_folder(const fs::path& folder, const RecordingOptions& options) {
  std::vector<fs::path> recordings;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_laser_recording(entry->path())) recordings.push_back(entry->path());
  }
  if (error) return Problem{{folder.string()}, "cannot be listed: " + error.message()};
  if (recordings.size() == 1) return read_laser_recording(recordings.front(), options);
  if (recordings.empty()) {
    return Problem{{folder.string()}, fmt::format("is a folder without a recording; {}", kWhatIsRead)};
  }
  std::sort(recordings.begin(), recordings.end());
  constexpr std::size_t kFilesOfRun = 2;
  if (recordings.size() == kFilesOfRun) {
    if (const auto run = lego_run(recordings))
      return with_choice(parse_lego_log(*run, folder.string(), options), options, folder);
  }
  return Problem{{folder.string()},
                 fmt::format("is a folder of {} recordings: name one of them, such as {}", recordings.size(),
                             recordings.front().string())};
}

}  // namespace

bool is_laser_recording(const fs::path& path) {
  if (is_bag(path)) return true;
  if (!fs::is_regular_file(path)) return false;
  const Result<std::string> head = read_unpacked_head(path, kRecordingHead);
  return head && recording_kind(*head) != RecordingKind::kOther;
}

Result<LaserRecording> read_laser_recording(const fs::path& path, const RecordingOptions& options) {
  std::error_code error;
  if (!fs::exists(path, error)) return Problem{{path.string()}, "no such file"};
  if (is_bag(path)) return read_laser_bag(path, options);
  if (fs::is_directory(path, error)) return read_recording_folder(path, options);
  return read_recording_file(path, options);
}

}  // namespace aisle
