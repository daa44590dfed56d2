#pragma once
/// What the stores of bags have in common: one file, read from front to back.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_reader.hpp"

namespace aisle {

/// The topics of a bag, shared by its files, and which of them are wanted.
class TopicTable {
 public:
  /// The index of the topic with this name and type, which is added if it is new.
  std::size_t index_of(const BagTopic& topic);

  void count(std::size_t topic, std::int64_t messages) { topics_[topic].messages += messages; }
  void want(const std::vector<std::size_t>& topics);
  bool is_wanted(std::size_t topic) const { return wanted_[topic]; }
  const std::vector<BagTopic>& topics() const { return topics_; }

 private:
  std::vector<BagTopic> topics_;
  std::vector<bool> wanted_;
  bool new_are_wanted_ = true;
};

/// "pkg/msg/Name" of the older "pkg/Name".
std::string with_msg(const std::string& type);

/// The encoding that a store calls so; a bag in another one cannot be read.
std::optional<BagEncoding> encoding_of(std::string_view name);

struct StoredMessage {
  std::size_t topic = 0;  ///< in the table
  ros::Stamp_ns log_stamp = 0;
  long number = 0;  ///< in the file; the first message is 1
  std::string_view bytes;
};

class BagStore {
 public:
  struct Survey {
    long messages = 0;
    std::optional<ros::Stamp_ns> first;  ///< log stamp of the first message
  };

  virtual ~BagStore() = default;

  /// Adds all topics to the table and counts their messages. Reading begins at the first message afterwards.
  virtual Result<Survey> survey() = 0;
  /// The next message of a wanted topic.
  virtual Result<std::optional<StoredMessage>> next() = 0;
  virtual void rewind() = 0;

  virtual Problems warnings() const { return warnings_; }

 protected:
  explicit BagStore(std::filesystem::path path, TopicTable& topics)
      : path_(std::move(path)), topics_(topics) {}

  /// Each sentence is kept once.
  void warn(std::string what);

  const std::filesystem::path& shown_path() const { return path_; }  ///< as the user knows it
  TopicTable& topics() { return topics_; }
  const TopicTable& topics() const { return topics_; }

 private:
  std::filesystem::path path_;
  TopicTable& topics_;
  Problems warnings_;
};

/// Whether a file begins as a bag does.
bool is_store(const std::filesystem::path& path);

/// Opens a file of a bag by its first bytes. The table must outlive the store.
Result<std::unique_ptr<BagStore>> open_store(const std::filesystem::path& path, TopicTable& topics);

}  // namespace aisle
