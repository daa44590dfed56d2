#pragma once

#include <string_view>

namespace aisle {

enum class RecordingKind { kCarmen, kRawlog, kCsv, kCoreslam, kLego, kBee, kOther };

/// How many of a file's first bytes tell its kind.
inline constexpr std::size_t kRecordingHead = 1 << 18;

/// @param head  the first bytes, unpacked
RecordingKind recording_kind(std::string_view head);

}  // namespace aisle
