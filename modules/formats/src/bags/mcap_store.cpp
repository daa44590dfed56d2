#include "bags/mcap_store.hpp"

#include <fmt/format.h>

#include <utility>

#include "mcap_records.hpp"
#include "sessions/session_metadata.hpp"

namespace aisle {
namespace {

constexpr std::size_t kChunkHead_bytes = 32;  ///< first and last time, size, checksum, length of a name
constexpr std::size_t kDescriptionMax_bytes = std::size_t{16} << 20;  ///< of a schema or channel
constexpr std::size_t kSummaryMax_bytes = std::size_t{64} << 20;

/// The fields of a record, one after the other. Beyond its end they are zero and empty.
class McapFields {
 public:
  explicit McapFields(std::string_view record) : rest_(record) {}

  template <class Number>
  Number number() {
    if (rest_.size() < sizeof(Number)) return is_short_ = true, rest_ = {}, Number{};
    const auto number = number_at<Number>(rest_);
    rest_.remove_prefix(sizeof(Number));
    return number;
  }
  std::string_view text() {
    const auto length = number<std::uint32_t>();
    if (length > rest_.size()) return is_short_ = true, rest_ = {}, std::string_view();
    const std::string_view text = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return text;
  }
  bool is_short() const { return is_short_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  bool is_short_ = false;
};

/// What a channel's map of texts says of the quality of service.
bool is_latched_channel(std::string_view map) {
  McapFields fields(map);
  while (!fields.rest().empty()) {
    const std::string_view key = fields.text();
    const std::string_view value = fields.text();
    if (key == "offered_qos_profiles") return is_latched(std::string(value));
  }
  return false;
}

}  // namespace

McapStore::McapStore(const std::filesystem::path& path, TopicTable& topics, ByteStream file)
    : RecordStore(path, topics, std::move(file), kMcapMagic.size()) {}

Result<BagStore::Survey> McapStore::survey() {
  std::optional<Survey> stated = summary();
  rewind();
  if (stated) return *stated;
  return RecordStore::survey();
}

RecordStore::Step McapStore::read_record(ByteStream& bytes, std::uint64_t left, StoredMessage& message) {
  const std::string_view head = bytes.peek(kMcapRecordHead_bytes);
  if (left < kMcapRecordHead_bytes || head.size() < kMcapRecordHead_bytes) return Step::kCut;
  const auto opcode = static_cast<std::uint8_t>(head[0]);
  const auto size = number_at<std::uint64_t>(head, 1);
  if (opcode == 0) return Step::kDamaged;
  if (opcode == mcap::kChunk && &bytes == &file()) return read_chunk(bytes, left);
  if (size > left - kMcapRecordHead_bytes) return Step::kCut;
  if (opcode == mcap::kMessage) return read_message(bytes, size, message);
  if (opcode == mcap::kDataEnd || opcode == mcap::kFooter) {
    end_seen_ = true;
    return Step::kEnd;
  }
  if ((opcode == mcap::kSchema || opcode == mcap::kChannel) && size <= kDescriptionMax_bytes) {
    const std::string_view record = bytes.peek(kMcapRecordHead_bytes + static_cast<std::size_t>(size));
    if (record.size() < kMcapRecordHead_bytes + size) return Step::kCut;
    opcode == mcap::kSchema ? read_schema(record.substr(kMcapRecordHead_bytes))
                            : read_channel(record.substr(kMcapRecordHead_bytes));
  }
  bytes.skip(kMcapRecordHead_bytes + size);
  return Step::kOther;
}

RecordStore::Step McapStore::read_chunk(ByteStream& bytes, std::uint64_t left) {
  const std::size_t fixed = kMcapRecordHead_bytes + kChunkHead_bytes;
  const std::string_view head = bytes.peek(fixed + 64);
  if (head.size() < fixed || left < fixed) return Step::kCut;
  const auto size = number_at<std::uint64_t>(head, kMcapRecordHead_bytes + 16);
  const auto name_bytes = number_at<std::uint32_t>(head, kMcapRecordHead_bytes + 28);
  if (name_bytes > 32) return Step::kDamaged;
  if (left < fixed + name_bytes + 8 || head.size() < fixed + name_bytes + 8) return Step::kCut;
  const std::string compression(head.substr(fixed, name_bytes));
  const auto packed_bytes = number_at<std::uint64_t>(head, fixed + name_bytes);
  bytes.skip(fixed + name_bytes + 8);
  return enter_chunk(compression, packed_bytes, size);
}

RecordStore::Step McapStore::read_message(ByteStream& bytes, std::uint64_t size, StoredMessage& message) {
  const std::string_view head = bytes.peek(kMcapRecordHead_bytes + kMcapMessageHead_bytes);
  if (size < kMcapMessageHead_bytes) return Step::kDamaged;
  if (head.size() < kMcapRecordHead_bytes + kMcapMessageHead_bytes) return Step::kCut;
  const auto channel = channels_.find(number_at<std::uint16_t>(head, kMcapRecordHead_bytes));
  const auto stamp_ns = number_at<std::uint64_t>(head, kMcapRecordHead_bytes + 6);
  const bool is_dated = stamp_ns < std::uint64_t{ros::kStampEnd_ns};
  if (!is_dated) warn("messages whose stamp is 2^62 ns or more are left out");
  if (channel == channels_.end()) warn("messages whose channel is not described are left out");
  if (!is_dated || channel == channels_.end() || channel->second == kUnread) {
    bytes.skip(kMcapRecordHead_bytes + size);
    return Step::kOther;
  }
  bytes.skip(kMcapRecordHead_bytes + kMcapMessageHead_bytes);
  return take_message(bytes, channel->second, static_cast<ros::Stamp_ns>(stamp_ns),
                      size - kMcapMessageHead_bytes, message);
}

void McapStore::read_schema(std::string_view record) {
  McapFields fields(record);
  const auto id = fields.number<std::uint16_t>();
  const std::string_view name = fields.text();
  if (!fields.is_short()) types_[id] = with_msg(std::string(name));
}

void McapStore::read_channel(std::string_view record) {
  McapFields fields(record);
  const auto id = fields.number<std::uint16_t>();
  const auto schema = fields.number<std::uint16_t>();
  const std::string_view topic = fields.text(), format = fields.text(), map = fields.text();
  if (fields.is_short() || channels_.contains(id)) return;  // a channel is repeated in later chunks
  const std::optional<BagEncoding> encoding = encoding_of(format);
  if (!encoding) {
    channels_[id] = kUnread;
    return warn(
        fmt::format("messages of {} are serialised as '{}'; only cdr and ros1 are read", topic, format));
  }
  channels_[id] = topics().index_of({.name = std::string(topic),
                                     .type = types_[schema],
                                     .latched = is_latched_channel(map),
                                     .encoding = *encoding});
}

std::optional<BagStore::Survey> McapStore::summary() {
  const std::size_t end_bytes = kMcapRecordHead_bytes + kMcapFooter_bytes + kMcapMagic.size();
  if (file().size() < kMcapMagic.size() + end_bytes) return std::nullopt;
  file().seek(file().size() - end_bytes);
  const std::string_view end = file().peek(end_bytes);
  if (end.size() < end_bytes || end[0] != mcap::kFooter || !end.ends_with(kMcapMagic)) return std::nullopt;
  const auto begin = number_at<std::uint64_t>(end, kMcapRecordHead_bytes);
  const std::uint64_t stop = file().size() - end_bytes;
  if (begin < kMcapMagic.size() || begin >= stop || stop - begin > kSummaryMax_bytes) return std::nullopt;
  file().seek(begin);
  McapFields records(file().peek(static_cast<std::size_t>(stop - begin)));
  std::string_view statistics;
  while (!records.rest().empty()) {
    const auto opcode = records.number<std::uint8_t>();
    const auto size = records.number<std::uint64_t>();
    if (records.is_short() || size > records.rest().size()) return std::nullopt;
    const std::string_view record = records.rest().substr(0, static_cast<std::size_t>(size));
    if (opcode == mcap::kSchema) read_schema(record);
    if (opcode == mcap::kChannel) read_channel(record);
    if (opcode == mcap::kStatistics) statistics = record;
    records = McapFields(records.rest().substr(record.size()));
  }
  McapFields fields(statistics);
  Survey survey;
  survey.messages = static_cast<long>(fields.number<std::uint64_t>());
  fields.number<std::uint16_t>();  // schemas; then channels, attachments, metadata, chunks
  for (int i = 0; i < 4; ++i) fields.number<std::uint32_t>();
  const auto first_ns = fields.number<std::uint64_t>();
  if (first_ns >= std::uint64_t{ros::kStampEnd_ns}) return std::nullopt;
  survey.first = static_cast<ros::Stamp_ns>(first_ns);
  fields.number<std::uint64_t>();  // last stamp
  std::vector<std::pair<std::size_t, std::int64_t>> counts;
  McapFields pairs(fields.text());
  long counted = 0;
  while (!fields.is_short() && !pairs.rest().empty()) {
    const auto channel = channels_.find(pairs.number<std::uint16_t>());
    const auto messages = static_cast<std::int64_t>(pairs.number<std::uint64_t>());
    if (pairs.is_short() || channel == channels_.end()) return std::nullopt;
    counted += messages;
    if (channel->second != kUnread) counts.emplace_back(channel->second, messages);
  }
  if (fields.is_short() || counted != survey.messages) return std::nullopt;
  for (const auto& [topic, messages] : counts) topics().count(topic, messages);
  return survey;
}

}  // namespace aisle
