#include "aisle/formats/sessions/session_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "sessions/session_files.hpp"
#include "sessions/session_recording.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr ros::Stamp_ns kTransaction_ns = 1'000'000'000;

bool is_name(const std::string& text) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '/';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_allowed);
}

}  // namespace

SessionWriter::SessionWriter(fs::path directory, std::unique_ptr<SessionRecording> recording)
    : directory_(std::move(directory)), recording_(std::move(recording)) {}
SessionWriter::SessionWriter(SessionWriter&&) noexcept = default;
SessionWriter& SessionWriter::operator=(SessionWriter&&) noexcept = default;

SessionWriter::~SessionWriter() {
  (void)close();
}

Result<SessionWriter> SessionWriter::create(const fs::path& directory, bool force, SessionStorage storage) {
  if (Problems problems = prepare_directory(directory, force); !problems.empty()) return problems;
  const SessionMetadata nothing_yet{.storage = storage,
                                    .file_name = storage_path(directory, storage).filename().string()};
  if (Problems problems = write_whole_file(directory / kMetadataName, metadata_yaml(nothing_yet));
      !problems.empty())
    return problems;
  auto recording = storage == SessionStorage::kMcap ? record_mcap(directory) : record_sqlite(directory);
  if (!recording) return recording.problems();
  return SessionWriter(directory, std::move(*recording));
}

/// A transaction ends before the first message that is a second later than its first one, so messages of one
/// stamp are never split.
Problems SessionWriter::write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  if (!failure_.empty()) return failure_;
  if (!is_name(topic.name) || !is_name(topic.type)) {
    return keep(
        {{{directory_.string()}, fmt::format("'{}' of type '{}' is no topic", topic.name, topic.type)}});
  }
  if (!transaction_start_ || stamp >= *transaction_start_ + kTransaction_ns) {
    if (Problems problems = keep(recording_->commit()); !problems.empty()) return problems;
    transaction_start_ = stamp;
  }
  return keep(recording_->write(topic, stamp, cdr));
}

Problems SessionWriter::keep(Problems problems) {
  if (!problems.empty()) failure_ = problems;
  return problems;
}

Problems SessionWriter::close() {
  const auto recording = std::exchange(recording_, nullptr);
  if (!recording || !failure_.empty()) return failure_;
  if (Problems problems = keep(recording->commit()); !problems.empty()) return problems;
  return keep(recording->finish());
}

void SessionWriter::discard() {
  recording_.reset();
  remove_session(directory_);
}

}  // namespace aisle
