#pragma once

#include <span>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/formats/bags/bag_scan.hpp"

namespace aisle {

/// The messages of one topic in the order of recording.
struct MessageStream {
  std::string topic;
  std::vector<MessageTime> times;
};

/// The time of every message of every stream on one clock, that of the first stream; it never goes back
/// within a stream. Headers say when something was measured, so they are the clock; when a message was
/// recorded tells where they cannot be right:
/// - Without stamps in the headers, the time of recording is taken.
/// - A stream whose stamps are off against the first one's by more than half a second comes from another
/// clock and is
///   shifted.
/// - A clock that was set back or forward goes on as if it had not been.
/// Says so, and where messages are missing.
std::vector<std::vector<double>> stream_times_s(std::span<const MessageStream> streams,
                                                const std::string& file, Problems& warnings);

}  // namespace aisle
