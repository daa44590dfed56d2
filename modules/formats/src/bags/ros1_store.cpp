#include "bags/ros1_store.hpp"

#include <fmt/format.h>

namespace aisle {
namespace {

enum Ros1Opcode : std::uint8_t { kMessageData = 2, kBagHeader = 3, kChunkRecord = 5, kConnection = 7 };

constexpr std::size_t kHeaderMax_bytes = std::size_t{1} << 20;
constexpr std::size_t kConnectionMax_bytes = std::size_t{16} << 20;

/// Passes the next "name=value" of a record's header; nullopt after the last.
std::optional<std::pair<std::string_view, std::string_view>> next_field(std::string_view& fields) {
  if (fields.size() < 4) return std::nullopt;
  const auto size = number_at<std::uint32_t>(fields);
  if (size > fields.size() - 4) return std::nullopt;
  const std::string_view field = fields.substr(4, size);
  fields.remove_prefix(4 + size);
  const std::size_t equals = field.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  return std::pair(field.substr(0, equals), field.substr(equals + 1));
}

template <class Number>
void read_number(std::string_view value, Number& number) {
  if (value.size() == sizeof(Number)) number = number_at<Number>(value);
}

}  // namespace

/// The fields of a record's header that matter.
struct Ros1Store::Header {
  std::uint8_t opcode = 0;
  std::uint32_t connection = 0;
  std::uint32_t unpacked_bytes = 0;
  std::uint64_t time = 0;  ///< seconds in the lower half, nanoseconds in the upper one
  std::uint64_t index_begin = 0;
  std::string topic, compression;
  bool latched = false;
  std::string type;

  void read(std::string_view fields) {
    while (const auto field = next_field(fields)) {
      const auto& [name, value] = *field;
      if (name == "op") read_number(value, opcode);
      if (name == "conn") read_number(value, connection);
      if (name == "size") read_number(value, unpacked_bytes);
      if (name == "time") read_number(value, time);
      if (name == "index_pos") read_number(value, index_begin);
      if (name == "topic") topic = value;
      if (name == "type") type = value;
      if (name == "latching") latched = value == "1";
      if (name == "compression") compression = value;
    }
  }

  ros::Stamp_ns stamp() const {
    return static_cast<ros::Stamp_ns>(time & 0xFFFFFFFFU) * 1'000'000'000 +
           static_cast<ros::Stamp_ns>(time >> 32);
  }
};

RecordStore::Step Ros1Store::read_record(ByteStream& bytes, std::uint64_t left, StoredMessage& message) {
  if (left < 4) return Step::kCut;
  const std::string_view start = bytes.peek(4);
  if (start.size() < 4) return Step::kCut;
  const auto header_bytes = number_at<std::uint32_t>(start);
  if (header_bytes == 0 || header_bytes > kHeaderMax_bytes) return Step::kDamaged;
  const std::size_t head_bytes = 4 + header_bytes + 4;
  if (left < head_bytes) return Step::kCut;
  const std::string_view head = bytes.peek(head_bytes);
  if (head.size() < head_bytes) return Step::kCut;
  Header header;
  header.read(head.substr(4, header_bytes));
  const auto size = number_at<std::uint32_t>(head, 4 + header_bytes);
  if (header.opcode == kChunkRecord && &bytes == &file()) {
    bytes.skip(head_bytes);
    return enter_chunk(header.compression, size, header.unpacked_bytes);
  }
  if (size > left - head_bytes) return Step::kCut;
  if (header.opcode == kMessageData) {
    bytes.skip(head_bytes);
    const auto connection = connections_.find(header.connection);
    if (connection != connections_.end())
      return take_message(bytes, connection->second, header.stamp(), size, message);
    warn("messages whose connection is not described are left out");
    bytes.skip(size);
    return Step::kOther;
  }
  if (header.opcode == kBagHeader) index_begin_ = header.index_begin;
  bytes.skip(head_bytes);
  if (header.opcode == kConnection && size <= kConnectionMax_bytes) read_connection(header, bytes.peek(size));
  bytes.skip(size);
  return Step::kOther;
}

void Ros1Store::read_connection(const Header& header, std::string_view data) {
  Header description;
  description.read(data);
  if (description.type.empty()) return;
  connections_[header.connection] = topics().index_of({.name = header.topic,
                                                       .type = with_msg(description.type),
                                                       .latched = description.latched,
                                                       .encoding = BagEncoding::kRos1});
}

}  // namespace aisle
