#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/message_schema.hpp"
#include "aisle/formats/whole_file.hpp"
#include "mcap_records.hpp"
#include "sessions/session_files.hpp"
#include "sessions/session_recording.hpp"

namespace aisle {
namespace {

/// The content of a record, field by field; numbers are little-endian.
class McapContent {
 public:
  template <class Number>
  McapContent& number(Number value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  McapContent& text(std::string_view text) {
    return number(static_cast<std::uint32_t>(text.size())).raw(text);
  }
  McapContent& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void append_record(std::string& to, mcap::Opcode opcode, std::string_view content) {
  to += static_cast<char>(opcode);
  const std::uint64_t bytes = content.size();
  to.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  to += content;
}

/// What a reader needs to know of a type; nothing of one that is not aisle's.
std::string schema_of(const std::string& type) {
  try {
    return message_schema(type);
  } catch (const std::invalid_argument&) {
    return "";
  }
}

/// The chunk at hand, and what the summary at the end tells of those before.
class McapRecording final : public SessionRecording {
 public:
  McapRecording(std::filesystem::path directory, std::filesystem::path path)
      : directory_(std::move(directory)), path_(std::move(path)) {}
  ~McapRecording() override {
    if (file_ >= 0) ::close(file_);
  }
  McapRecording(const McapRecording&) = delete;
  McapRecording& operator=(const McapRecording&) = delete;

  Problems begin() {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file_ < 0) return failed("created");
    std::string head(kMcapMagic);
    append_record(head, mcap::kHeader, McapContent().text("ros2").text("aisle").bytes());
    return append(head);
  }

  Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;
  Problems commit() override;
  Problems finish() override;

 private:
  struct Chunk {
    std::string records;
    ros::Stamp_ns first = 0, last = 0;
    std::map<std::uint16_t, std::vector<std::pair<ros::Stamp_ns, std::uint64_t>>> messages;  ///< by channel
  };

  Result<std::uint16_t> channel_of(const SessionTopic& topic);
  std::string statistics() const;
  Problems append(std::string_view bytes);
  Problems failed(const char* step) const {
    return {{{path_.string()}, std::string("cannot be ") + step + ": " + std::strerror(errno)}};
  }

  std::filesystem::path directory_, path_;
  int file_ = -1;
  std::uint64_t written_bytes_ = 0;
  std::map<std::string, std::uint16_t> channels_;  ///< by topic
  std::map<std::string, std::uint16_t> schemas_;   ///< by type
  std::string descriptions_;                       ///< the records of all schemas and channels
  Chunk chunk_;
  std::string chunk_indexes_;
  std::uint32_t chunks_ = 0;
  SessionMetadata metadata_;
};

Problems McapRecording::write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  const auto channel = channel_of(topic);
  if (!channel) return channel.problems();
  auto& count = metadata_.topics[*channel - 1U].messages;
  const bool is_first = chunk_.messages.empty();
  chunk_.first = is_first ? stamp : std::min(chunk_.first, stamp);
  chunk_.last = is_first ? stamp : std::max(chunk_.last, stamp);
  chunk_.messages[*channel].emplace_back(stamp, chunk_.records.size());
  append_record(chunk_.records, mcap::kMessage,
                McapContent()
                    .number(*channel)
                    .number(static_cast<std::uint32_t>(count++))
                    .number(stamp)
                    .number(stamp)
                    .raw(cdr)
                    .bytes());
  metadata_.first = metadata_.messages == 0 ? stamp : std::min(metadata_.first, stamp);
  metadata_.last = metadata_.messages == 0 ? stamp : std::max(metadata_.last, stamp);
  ++metadata_.messages;
  return {};
}

/// Schema and channel come before a topic's first message, and once more in the summary.
Result<std::uint16_t> McapRecording::channel_of(const SessionTopic& topic) {
  if (const auto known = channels_.find(topic.name); known != channels_.end()) return known->second;
  if (channels_.size() == std::numeric_limits<std::uint16_t>::max())
    return Problem{{path_.string()}, "has more topics than MCAP can tell apart"};
  std::string described;
  const auto [schema, is_new] =
      schemas_.try_emplace(topic.type, static_cast<std::uint16_t>(schemas_.size() + 1));
  if (is_new) {
    const std::string definition = schema_of(topic.type);
    append_record(described, mcap::kSchema,
                  McapContent()
                      .number(schema->second)
                      .text(topic.type)
                      .text(definition.empty() ? "" : "ros2msg")
                      .text(definition)
                      .bytes());
  }
  const auto channel = static_cast<std::uint16_t>(channels_.size() + 1);
  const std::string quality =
      McapContent().text("offered_qos_profiles").text(quality_of_service(topic.latched)).bytes();
  append_record(described, mcap::kChannel,
                McapContent()
                    .number(channel)
                    .number(schema->second)
                    .text(topic.name)
                    .text("cdr")
                    .text(quality)
                    .bytes());
  channels_[topic.name] = channel;
  descriptions_ += described;
  chunk_.records += described;
  metadata_.topics.push_back({topic, 0});
  return channel;
}

Problems McapRecording::commit() {
  if (chunk_.records.empty()) return {};
  const Chunk chunk = std::exchange(chunk_, {});
  const auto* bytes = reinterpret_cast<const Bytef*>(chunk.records.data());
  const auto crc = static_cast<std::uint32_t>(::crc32_z(0, bytes, chunk.records.size()));
  const auto size = static_cast<std::uint64_t>(chunk.records.size());
  std::string out;
  append_record(out, mcap::kChunk,
                McapContent()
                    .number(chunk.first)
                    .number(chunk.last)
                    .number(size)
                    .number(crc)
                    .text("")  // not compressed: images are already
                    .number(size)
                    .raw(chunk.records)
                    .bytes());
  const std::uint64_t chunk_bytes = out.size();
  McapContent offsets;
  for (const auto& [channel, messages] : chunk.messages) {
    offsets.number(channel).number(written_bytes_ + out.size());
    McapContent places;
    for (const auto& [stamp, offset] : messages) places.number(stamp).number(offset);
    append_record(out, mcap::kMessageIndex, McapContent().number(channel).text(places.bytes()).bytes());
  }
  append_record(chunk_indexes_, mcap::kChunkIndex,
                McapContent()
                    .number(chunk.first)
                    .number(chunk.last)
                    .number(written_bytes_)
                    .number(chunk_bytes)
                    .text(offsets.bytes())
                    .number(static_cast<std::uint64_t>(out.size() - chunk_bytes))
                    .text("")
                    .number(size)
                    .number(size)
                    .bytes());
  ++chunks_;
  return append(out);
}

/// The summary lets readers begin anywhere; without it, all of them still find every message.
Problems McapRecording::finish() {
  constexpr std::uint32_t kNoChecksum = 0;
  std::string out;
  append_record(out, mcap::kDataEnd, McapContent().number(kNoChecksum).bytes());
  const std::uint64_t summary = written_bytes_ + out.size();
  out += descriptions_;
  append_record(out, mcap::kStatistics, statistics());
  out += chunk_indexes_;
  const std::uint64_t no_offsets = 0;
  append_record(out, mcap::kFooter,
                McapContent().number(summary).number(no_offsets).number(kNoChecksum).bytes());
  out += kMcapMagic;
  if (Problems problems = append(out); !problems.empty()) return problems;
  if (::close(std::exchange(file_, -1)) != 0) return failed("written");
  metadata_.storage = SessionStorage::kMcap;
  metadata_.file_name = path_.filename().string();
  return write_whole_file(directory_ / kMetadataName, metadata_yaml(metadata_));
}

std::string McapRecording::statistics() const {
  McapContent counts;
  for (std::size_t i = 0; i < metadata_.topics.size(); ++i)
    counts.number(static_cast<std::uint16_t>(i + 1)).number(metadata_.topics[i].messages);
  constexpr std::uint32_t kNone = 0;
  return McapContent()
      .number(metadata_.messages)
      .number(static_cast<std::uint16_t>(schemas_.size()))
      .number(static_cast<std::uint32_t>(channels_.size()))
      .number(kNone)  // attachments
      .number(kNone)  // metadata
      .number(chunks_)
      .number(metadata_.first)
      .number(metadata_.last)
      .text(counts.bytes())
      .bytes();
}

Problems McapRecording::append(std::string_view bytes) {
  written_bytes_ += bytes.size();
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed("written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<SessionRecording>> record_mcap(const std::filesystem::path& directory) {
  auto recording = std::make_unique<McapRecording>(directory, storage_path(directory, SessionStorage::kMcap));
  if (Problems problems = recording->begin(); !problems.empty()) return problems;
  return std::unique_ptr<SessionRecording>(std::move(recording));
}

}  // namespace aisle
