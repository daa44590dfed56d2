#include "logs/recording_kind.hpp"

#include <algorithm>
#include <array>

#include "aisle/formats/file_contents.hpp"
#include "aisle/formats/logs/bee_log.hpp"
#include "aisle/formats/logs/counted_log.hpp"
#include "field_reader.hpp"
#include "logs/laser_csv_columns.hpp"
#include "logs/mrpt_stream.hpp"

namespace aisle {
namespace {

bool has_carmen_message(std::string_view head) {
  constexpr std::array<std::string_view, 9> kMessages = {
      "FLASER", "RLASER", "RAWLASER1", "RAWLASER2", "ROBOTLASER1", "ROBOTLASER2", "ODOM", "PARAM", "SYNC"};
  while (!head.empty()) {
    const std::string_view line = take_line(head);
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    if (word.size() < line.size() && std::find(kMessages.begin(), kMessages.end(), word) != kMessages.end()) {
      return true;
    }
  }
  return false;
}

}  // namespace

RecordingKind recording_kind(std::string_view head) {
  if (begins_rawlog(head)) return RecordingKind::kRawlog;
  if (is_tar_archive(head)) return RecordingKind::kOther;
  if (has_carmen_message(head)) return RecordingKind::kCarmen;
  if (begins_laser_csv(head)) return RecordingKind::kCsv;
  if (begins_bee_log(head)) return RecordingKind::kBee;
  if (begins_coreslam_log(head)) return RecordingKind::kCoreslam;
  return begins_lego_log(head) ? RecordingKind::kLego : RecordingKind::kOther;
}

}  // namespace aisle
