#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

/// A period in which a regular topic sent nothing for at least three times its usual interval.
struct SessionGap {
  double start_s = 0;  ///< since the session's first message
  double length_s = 0;
};

struct TopicSummary {
  SessionTopic topic;
  std::int64_t messages = 0;
  std::int64_t bytes = 0;   ///< of the messages alone
  double interval_s = 0;    ///< median time from one message to the next; 0 with fewer than two
  bool is_regular = false;  ///< ten or more messages, nine in ten intervals between half and twice the median
  std::vector<SessionGap> gaps;  ///< only of regular topics
};

/// What a session contains.
struct SessionSummary {
  ros::Stamp_ns first = 0;
  ros::Stamp_ns last = 0;
  std::int64_t messages = 0;
  std::uintmax_t file_bytes = 0;  ///< of the database
  std::vector<TopicSummary> topics;

  double duration_s() const { return static_cast<double>(last - first) / 1e9; }
};

/// What a list of sessions says of one.
struct SessionOutline {
  std::string file;  ///< beside metadata.yaml
  double duration_s = 0;
  std::int64_t messages = 0;
};

/// Reads metadata.yaml alone, unless the recording did not end properly: then as summarise_session().
Result<SessionOutline> outline_session(const std::filesystem::path& directory);

/// Summarises any bag that SessionReader reads, without decoding the messages.
Result<SessionSummary> summarise_session(const std::filesystem::path& directory);

}  // namespace aisle
