#include "bags/record_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bags/unpacking.hpp"

namespace aisle {

RecordStore::RecordStore(std::filesystem::path path, TopicTable& topics, ByteStream file, std::uint64_t begin)
    : BagStore(std::move(path), topics), file_(std::move(file)), begin_(begin) {
  file_.seek(begin_);
}

void RecordStore::rewind() {
  file_.seek(begin_);
  chunk_ = ByteStream();
  open_chunk_end_ = 0;
  ended_ = false;
  number_ = 0;
}

Result<BagStore::Survey> RecordStore::survey() {
  rewind();
  surveying_ = true;
  Survey survey;
  StoredMessage message;
  while (advance(message)) {
    if (!survey.first) survey.first = message.log_stamp;
    topics().count(message.topic, 1);
    ++survey.messages;
  }
  surveying_ = false;
  rewind();
  return survey;
}

Result<std::optional<StoredMessage>> RecordStore::next() {
  StoredMessage message;
  while (advance(message)) {
    if (topics().is_wanted(message.topic)) return std::optional(message);
  }
  return std::optional<StoredMessage>();
}

bool RecordStore::advance(StoredMessage& message) {
  while (!ended_) {
    if (step(message) != Step::kMessage) continue;
    message.number = ++number_;
    return true;
  }
  return false;
}

RecordStore::Step RecordStore::step(StoredMessage& message) {
  if (chunk_.left() == 0) return step_in_file(message);
  const Step step = read_record(chunk_, chunk_.left(), message);
  if (step == Step::kMessage || step == Step::kOther) return step;
  if (file_.left() > 0)
    warn(fmt::format("the chunk at byte {} is damaged; only its first messages are read", chunk_begin_));
  chunk_ = ByteStream();
  return Step::kOther;
}

RecordStore::Step RecordStore::step_in_file(StoredMessage& message) {
  if (file_.position() == open_chunk_end_) open_chunk_end_ = 0;
  const bool in_chunk = open_chunk_end_ > 0 && open_chunk_end_ <= file_.size();
  const std::uint64_t left = in_chunk ? open_chunk_end_ - file_.position() : file_.left();
  const std::uint64_t at = file_.position();
  const Step step = left == 0 ? Step::kEnd : read_record(file_, left, message);
  if (step == Step::kMessage || step == Step::kOther) return step;
  if (in_chunk) {
    warn(fmt::format("the chunk that ends at byte {} is damaged from byte {} on", open_chunk_end_, at));
    file_.seek(open_chunk_end_);
    return Step::kOther;
  }
  ended_ = true;
  if (step == Step::kDamaged)
    warn(fmt::format("is damaged at byte {}; the {} messages before are read", at, number_));
  if (step == Step::kCut || (step == Step::kEnd && !is_closed()))
    warn(fmt::format("is cut off at byte {}; the {} messages before are read", at, number_));
  return step;
}

RecordStore::Step RecordStore::enter_chunk(std::string_view compression, std::uint64_t packed_bytes,
                                           std::uint64_t unpacked_bytes) {
  if (compression.empty() || compression == "none") {
    open_chunk_end_ = file_.position() + packed_bytes;
    return Step::kOther;
  }
  chunk_begin_ = file_.position();
  const std::uint64_t there = std::min(packed_bytes, file_.left());
  if (!is_compression(compression)) {
    warn(fmt::format("chunks compressed by '{}' are left out; zstd, lz4 and bz2 are read", compression));
  } else if (std::max(there, unpacked_bytes) > kUnpackedMax_bytes) {
    warn(fmt::format("the chunk at byte {} is left out: it claims {} bytes, at most {} are read",
                     chunk_begin_, std::max(there, unpacked_bytes), kUnpackedMax_bytes));
  } else {
    const std::string method(compression);  // the bytes of the record's header go when the content is read
    const auto bytes = static_cast<std::size_t>(unpacked_bytes);
    const std::string_view content =
        unpacked(method, file_.peek(static_cast<std::size_t>(there)), bytes, buffer_);
    chunk_ = ByteStream(content);
    if (content.size() != bytes && there == packed_bytes)
      warn(fmt::format("the chunk at byte {} is damaged; {} of its {} bytes could be unpacked", chunk_begin_,
                       content.size(), bytes));
  }
  file_.skip(there);  // if the chunk is cut off, the end of the file says so
  return Step::kOther;
}

RecordStore::Step RecordStore::take_message(ByteStream& bytes, std::size_t topic, ros::Stamp_ns stamp,
                                            std::uint64_t size, StoredMessage& message) {
  message.topic = topic;
  message.log_stamp = stamp;
  message.bytes = {};
  if (!surveying_ && topics().is_wanted(topic)) {
    if (size > kUnpackedMax_bytes) return Step::kDamaged;
    message.bytes = bytes.peek(static_cast<std::size_t>(size));
    if (message.bytes.size() < size) return Step::kCut;
  }
  bytes.skip(size);
  return Step::kMessage;
}

}  // namespace aisle
