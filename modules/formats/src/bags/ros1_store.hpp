#pragma once

#include <unordered_map>

#include "bags/record_store.hpp"

namespace aisle {

/// A bag of ROS 1, version 2.0.
class Ros1Store : public RecordStore {
 public:
  static constexpr std::string_view kMagic = "#ROSBAG V2.0\n";

  Ros1Store(const std::filesystem::path& path, TopicTable& topics, ByteStream file)
      : RecordStore(path, topics, std::move(file), kMagic.size()) {}

 protected:
  Step read_record(ByteStream& bytes, std::uint64_t left, StoredMessage& message) override;
  bool is_closed() const override { return index_begin_ > 0 && index_begin_ <= file().size(); }

 private:
  struct Header;

  void read_connection(const Header& header, std::string_view data);

  std::unordered_map<std::uint32_t, std::size_t> connections_;  ///< topic
  std::uint64_t index_begin_ = 0;                               ///< 0: never written
};

}  // namespace aisle
