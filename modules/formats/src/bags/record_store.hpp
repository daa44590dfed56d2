#pragma once

#include "bags/bag_store.hpp"
#include "bags/byte_stream.hpp"

namespace aisle {

/// A file of records, some of which are chunks of records: MCAP and ROS 1. It is read record by record
/// without its index, so an index that is missing or wrong does no harm. At most one chunk is in memory.
class RecordStore : public BagStore {
 public:
  Result<Survey> survey() override;
  Result<std::optional<StoredMessage>> next() override;
  void rewind() override;

 protected:
  enum class Step {
    kMessage,  ///< `message` was set
    kOther,    ///< something else was passed
    kEnd,      ///< no more messages follow
    kCut,      ///< the record does not fit into the bytes that are left
    kDamaged,  ///< this is no record
  };

  RecordStore(std::filesystem::path path, TopicTable& topics, ByteStream file, std::uint64_t begin);

  /// Reads the record at the front of `bytes`.
  /// @param left  bytes up to the end of the chunk or file; they may be fewer than a record claims
  virtual Step read_record(ByteStream& bytes, std::uint64_t left, StoredMessage& message) = 0;
  /// Whether the file says that it was closed properly, and ends where it says.
  virtual bool is_closed() const = 0;

  /// Called with the file at the chunk's content.
  Step enter_chunk(std::string_view compression, std::uint64_t packed_bytes, std::uint64_t unpacked_bytes);
  /// Sets the message; its bytes are read only if they are wanted.
  Step take_message(ByteStream& bytes, std::size_t topic, ros::Stamp_ns stamp, std::uint64_t size,
                    StoredMessage& message);

  ByteStream& file() { return file_; }
  const ByteStream& file() const { return file_; }

 private:
  /// @return whether there is another message, wanted or not
  bool advance(StoredMessage& message);
  Step step(StoredMessage& message);
  Step step_in_file(StoredMessage& message);

  ByteStream file_;
  std::uint64_t begin_;  ///< of the first record
  Buffer buffer_;        ///< of the unpacked chunk
  ByteStream chunk_;     ///< what is left of it
  std::uint64_t chunk_begin_ = 0;
  std::uint64_t open_chunk_end_ = 0;  ///< of a chunk that is not compressed, within the file; 0: not in one
  bool surveying_ = false;
  bool ended_ = false;
  long number_ = 0;
};

}  // namespace aisle
