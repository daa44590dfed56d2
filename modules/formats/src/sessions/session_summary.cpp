#include "aisle/formats/sessions/session_summary.hpp"

#include <algorithm>
#include <utility>

#include "aisle/core/median.hpp"
#include "sessions/session_files.hpp"
#include "sessions/session_source.hpp"

namespace aisle {
namespace {

constexpr std::size_t kRegularFrom = 10;
constexpr double kRegularShare = 0.9;
constexpr double kGapIntervals = 3;

double seconds(ros::Stamp_ns duration) {
  return static_cast<double>(duration) / 1e9;
}

bool is_regular(const std::vector<double>& intervals_s, double usual_s) {
  const auto usual = std::count_if(intervals_s.begin(), intervals_s.end(), [&](double interval_s) {
    return interval_s >= usual_s / 2 && interval_s <= usual_s * 2;
  });
  return intervals_s.size() + 1 >= kRegularFrom &&
         static_cast<double>(usual) >= kRegularShare * static_cast<double>(intervals_s.size());
}

/// Fills in the statistics of the messages' times.
void summarise_times(TopicSummary& topic, const std::vector<ros::Stamp_ns>& stamps, ros::Stamp_ns start) {
  if (stamps.size() < 2) return;
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < stamps.size(); ++i) intervals_s.push_back(seconds(stamps[i] - stamps[i - 1]));
  topic.interval_s = median(intervals_s);
  topic.is_regular = is_regular(intervals_s, topic.interval_s);
  if (!topic.is_regular) return;
  for (std::size_t i = 0; i < intervals_s.size(); ++i) {
    if (intervals_s[i] >= kGapIntervals * topic.interval_s)
      topic.gaps.push_back({seconds(stamps[i] - start), intervals_s[i]});
  }
}

Result<SessionSummary> summarise(SessionSource& source) {
  SessionSummary summary;
  for (const SessionTopic& topic : source.topics()) summary.topics.push_back({.topic = topic});
  std::vector<std::vector<ros::Stamp_ns>> stamps(summary.topics.size());
  while (true) {
    const auto row = source.next_row();
    if (!row) return row.problems();
    if (!*row) break;
    const auto& [topic, stamp, bytes] = **row;
    if (summary.messages++ == 0) summary.first = stamp;
    summary.last = stamp;
    ++summary.topics[topic].messages;
    summary.topics[topic].bytes += bytes;
    stamps[topic].push_back(stamp);
  }
  for (std::size_t i = 0; i < stamps.size(); ++i)
    summarise_times(summary.topics[i], stamps[i], summary.first);
  return summary;
}

}  // namespace

Result<SessionOutline> outline_session(const std::filesystem::path& directory) {
  auto file = find_session_file(directory);
  if (!file) return file.problems();
  if (file->messages > 0) return SessionOutline{std::move(file->name), file->duration_s, file->messages};
  const auto summary = summarise_session(directory);
  if (!summary) return summary.problems();
  return SessionOutline{std::move(file->name), summary->duration_s(), summary->messages};
}

Result<SessionSummary> summarise_session(const std::filesystem::path& directory) {
  const auto source = open_session_source(directory);
  if (!source) return source.problems();
  auto summary = summarise(**source);
  if (!summary) return summary;
  std::error_code error;
  summary->file_bytes = std::filesystem::file_size((*source)->path(), error);
  return summary;
}

}  // namespace aisle
