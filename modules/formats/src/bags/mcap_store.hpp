#pragma once

#include <map>
#include <string>
#include <unordered_map>

#include "bags/record_store.hpp"

namespace aisle {

/// An MCAP file (mcap.dev), with or without its summary.
class McapStore : public RecordStore {
 public:
  McapStore(const std::filesystem::path& path, TopicTable& topics, ByteStream file);

  Result<Survey> survey() override;

 protected:
  Step read_record(ByteStream& bytes, std::uint64_t left, StoredMessage& message) override;
  bool is_closed() const override { return end_seen_; }

 private:
  static constexpr std::size_t kUnread = std::size_t(-1);

  Step read_chunk(ByteStream& bytes, std::uint64_t left);
  Step read_message(ByteStream& bytes, std::uint64_t size, StoredMessage& message);
  void read_schema(std::string_view record);
  void read_channel(std::string_view record);
  /// The survey by the summary at the end of the file; nullopt if it does not tell all.
  std::optional<Survey> summary();

  std::unordered_map<std::uint16_t, std::string> types_;     ///< by schema
  std::unordered_map<std::uint16_t, std::size_t> channels_;  ///< topic, or kUnread
  bool end_seen_ = false;
};

}  // namespace aisle
