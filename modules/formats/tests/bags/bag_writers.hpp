#pragma once
/// Small bags to test with, in all three stores, and with the faults of those that others wrote.

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "sessions/sqlite.hpp"
#include "written_file.hpp"

namespace aisle {

struct WrittenMessage {
  std::string topic, type;  ///< "/scan", "sensor_msgs/msg/LaserScan"
  ros::Stamp_ns log_stamp = 0;
  std::string bytes;
};

template <class Number>
std::string number_bytes(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof(number)};
}

inline std::string sized(const std::string& text) {
  return number_bytes(static_cast<std::uint32_t>(text.size())) + text;
}

inline std::string packed(const std::string& compression, const std::string& bytes) {
  std::string out(bytes.size() * 2 + 1000, '\0');
  if (compression == "zstd") {
    out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  } else if (compression == "lz4") {
    out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
  } else if (compression == "bz2") {
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()),
                             static_cast<unsigned>(bytes.size()), 1, 0, 0);
    out.resize(size);
  } else {
    return bytes;
  }
  return out;
}

/// The bytes of a message as ROS 1 writes it.
class Ros1Bytes {
 public:
  template <class Field>
  void operator()(const char* /*name*/, const Field& field) {
    write(field);
  }
  template <class Message>
  static std::string of(const Message& message) {
    Ros1Bytes bytes;
    bytes.write(message);
    return bytes.bytes_;
  }

 private:
  template <class Field>
  void write(const Field& field) {
    if constexpr (std::is_arithmetic_v<Field>) {
      bytes_ += number_bytes(field);
    } else {
      if constexpr (std::is_same_v<Field, ros::Header>) bytes_ += number_bytes(std::uint32_t{7});  // sequence
      Field::fields(field, *this);
    }
  }
  void write(const std::string& text) { bytes_ += sized(text); }
  template <class Element, std::size_t count>
  void write(const std::array<Element, count>& elements) {
    for (const Element& element : elements) write(element);
  }
  template <class Element>
  void write(const std::vector<Element>& elements) {
    bytes_ += number_bytes(static_cast<std::uint32_t>(elements.size()));
    for (const Element& element : elements) write(element);
  }

  std::string bytes_;
};

enum class Written { kCdr, kRos1 };

template <class Message>
WrittenMessage written(const std::string& topic, double log_s, const Message& message,
                       Written as = Written::kCdr) {
  return {topic, Message::kType, ros::stamp_ns(log_s),
          as == Written::kCdr ? cdr_bytes(message) : Ros1Bytes::of(message)};
}

inline std::string mcap_record(int opcode, const std::string& body) {
  return static_cast<char>(opcode) + number_bytes(std::uint64_t{body.size()}) + body;
}

struct McapLayout {
  std::string compression = {};
  std::size_t chunk_messages = 4;  ///< 0: no chunks
  bool has_summary = true;
  std::string encoding = "cdr";
};

/// An MCAP file piece by piece, with records in between that no reader knows.
class McapWriter {
 public:
  explicit McapWriter(McapLayout layout) : layout_(std::move(layout)) {}

  void add(const WrittenMessage& message) {
    const auto [channel, is_new] =
        channels_.try_emplace(message.topic, static_cast<std::uint16_t>(channels_.size() + 1));
    const std::string id = number_bytes(channel->second);
    if (is_new) {
      const std::string description =
          mcap_record(3, id + sized(message.type) + sized("ros2msg") + sized("")) +
          mcap_record(4, id + id + sized(message.topic) + sized(layout_.encoding) +
                             sized(sized("offered_qos_profiles") + sized("- durability: transient_local\n")));
      chunk_ += description;
      descriptions_ += description;
    }
    if (messages_++ == 0) first_ = message.log_stamp;
    ++counts_[channel->second];
    chunk_ += mcap_record(5, id + std::string(4, '\0') + number_bytes(message.log_stamp) +
                                 std::string(8, '\0') + message.bytes);
    if (++in_chunk_ == layout_.chunk_messages) end_chunk();
  }

  void finish() {
    end_chunk();
    out_ += mcap_record(15, std::string(4, '\0'));
    const std::uint64_t summary = layout_.has_summary ? taken_bytes_ + out_.size() : 0;
    if (layout_.has_summary) {
      std::string pairs;
      for (const auto& [channel, count] : counts_) pairs += number_bytes(channel) + number_bytes(count);
      out_ += descriptions_ + mcap_record(11, number_bytes(messages_) + std::string(18, '\0') +
                                                  number_bytes(first_) + std::string(8, '\0') + sized(pairs));
    }
    out_ += mcap_record(2, number_bytes(summary) + std::string(12, '\0')) + magic();
  }

  /// The bytes since the last time.
  std::string take() {
    taken_bytes_ += out_.size();
    return std::exchange(out_, {});
  }

 private:
  static std::string magic() { return {"\x89MCAP0\r\n", 8}; }

  void end_chunk() {
    if (layout_.chunk_messages > 0 && !chunk_.empty()) {
      const std::string content = packed(layout_.compression, chunk_);
      out_ += mcap_record(6, std::string(16, '\0') + number_bytes(std::uint64_t{chunk_.size()}) +
                                 std::string(4, '\0') + sized(layout_.compression) +
                                 number_bytes(std::uint64_t{content.size()}) + content);
    } else {
      out_ += chunk_;
    }
    out_ += mcap_record(0x90, "whatever");
    chunk_.clear();
    in_chunk_ = 0;
  }

  McapLayout layout_;
  std::map<std::string, std::uint16_t> channels_;
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::string descriptions_, chunk_, out_ = magic() + mcap_record(1, sized("ros2") + sized("test"));
  std::uint64_t taken_bytes_ = 0, messages_ = 0;
  ros::Stamp_ns first_ = 0;
  std::size_t in_chunk_ = 0;
};

inline std::string mcap_bytes(const std::vector<WrittenMessage>& messages, const McapLayout& layout = {}) {
  McapWriter writer(layout);
  for (const WrittenMessage& message : messages) writer.add(message);
  writer.finish();
  return writer.take();
}

inline std::string ros1_field(const std::string& name, const std::string& value) {
  return sized(name + "=" + value);
}

inline std::string ros1_record(int opcode, const std::string& fields, const std::string& data) {
  return sized(ros1_field("op", std::string(1, static_cast<char>(opcode))) + fields) + sized(data);
}

struct Ros1Layout {
  std::string compression = "none";
  std::size_t chunk_messages = 4;
  bool has_index = true;  ///< one that is wrong in all but its place
};

inline std::string ros1_bag_bytes(const std::vector<WrittenMessage>& messages,
                                  const Ros1Layout& layout = {}) {
  std::map<std::string, std::uint32_t> connections;
  const auto bag_header = [](std::uint64_t index) {
    return "#ROSBAG V2.0\n" +
           ros1_record(3, ros1_field("index_pos", number_bytes(index)), std::string(40, ' '));
  };
  std::string chunk, out;
  std::size_t in_chunk = 0;
  const auto end_chunk = [&] {
    if (chunk.empty()) return;
    out += ros1_record(5,
                       ros1_field("compression", layout.compression) +
                           ros1_field("size", number_bytes(static_cast<std::uint32_t>(chunk.size()))),
                       packed(layout.compression, chunk));
    out += ros1_record(4, ros1_field("conn", number_bytes(std::uint32_t{0})), std::string(12, '\xFF'));
    chunk.clear();
    in_chunk = 0;
  };
  for (const WrittenMessage& message : messages) {
    const auto [connection, is_new] =
        connections.try_emplace(message.topic, static_cast<std::uint32_t>(connections.size()));
    const std::string id = ros1_field("conn", number_bytes(connection->second));
    std::string type = message.type;
    if (const std::size_t msg = type.find("/msg"); msg != std::string::npos) type.erase(msg, 4);
    if (is_new)
      chunk +=
          ros1_record(7, id + ros1_field("topic", message.topic),
                      ros1_field("type", type) + ros1_field("latching", "1") + ros1_field("md5sum", "*"));
    const auto s = static_cast<std::uint32_t>(message.log_stamp / 1'000'000'000);
    const auto ns = static_cast<std::uint32_t>(message.log_stamp % 1'000'000'000);
    chunk += ros1_record(2, id + ros1_field("time", number_bytes(s) + number_bytes(ns)), message.bytes);
    if (++in_chunk == layout.chunk_messages) end_chunk();
  }
  end_chunk();
  const std::uint64_t index = layout.has_index ? bag_header(0).size() + out.size() : 0;
  return bag_header(index) + out;
}

/// @param schema  version of rosbag2's tables, 1 to 4
inline void write_db3(const std::filesystem::path& path, const std::vector<WrittenMessage>& messages,
                      int schema = 4, const std::string& format = "cdr") {
  auto database = sqlite::Database::create(path);
  std::string sql =
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
      "serialization_format TEXT "
      "NOT NULL" +
      std::string(schema > 1 ? ", offered_qos_profiles TEXT NOT NULL" : "") +
      "); CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
      "NULL, data BLOB "
      "NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
  if (schema > 1) sql += "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);";
  if (schema > 2)
    sql += "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER, metadata TEXT);";
  if (schema > 3) sql += "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT);";
  (void)database->run(sql.c_str());
  std::map<std::string, std::int64_t> topics;
  (void)database->run("BEGIN");
  for (const WrittenMessage& message : messages) {
    const auto [topic, is_new] =
        topics.try_emplace(message.topic, static_cast<std::int64_t>(topics.size() + 1));
    if (is_new)
      (void)database->run(fmt::format("INSERT INTO topics VALUES ({}, '{}', '{}', '{}'{})", topic->second,
                                      message.topic, message.type, format,
                                      schema > 1 ? ", 'durability: 1\n'" : "")
                              .c_str());
    auto insert = database->prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
    insert->bind(0, topic->second);
    insert->bind(1, message.log_stamp);
    insert->bind_blob(2, message.bytes);
    (void)insert->run();
  }
  (void)database->run("COMMIT; PRAGMA journal_mode = DELETE");
}

}  // namespace aisle
