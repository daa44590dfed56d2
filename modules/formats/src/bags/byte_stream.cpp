#include "bags/byte_stream.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "input_file.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBlock_bytes = std::size_t{256} << 10;

}  // namespace

char* Buffer::room(std::size_t bytes) {
  if (bytes > bytes_) {
    memory_.reset();
    memory_ = std::make_unique_for_overwrite<char[]>(bytes);
    bytes_ = bytes;
  }
  return memory_.get();
}

Result<ByteStream> ByteStream::open(const std::filesystem::path& path) {
  auto file = InputFile::open(path);
  if (!file) return file.problems();
  ByteStream stream;
  stream.end_ = file->bytes();
  stream.file_ = file->release();
  return stream;
}

ByteStream::ByteStream(ByteStream&& other) noexcept {
  *this = std::move(other);
}

ByteStream& ByteStream::operator=(ByteStream&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(buffer_, other.buffer_);
  std::swap(block_, other.block_);
  std::swap(block_begin_, other.block_begin_);
  std::swap(position_, other.position_);
  std::swap(end_, other.end_);
  return *this;
}

ByteStream::~ByteStream() {
  if (file_ >= 0) ::close(file_);
}

std::string_view ByteStream::peek(std::size_t bytes) {
  bytes = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, left()));
  const auto is_in_block = [&] {
    return position_ >= block_begin_ && position_ - block_begin_ + bytes <= block_.size();
  };
  if (!is_in_block()) read_block(std::max(bytes, kBlock_bytes));
  if (position_ < block_begin_ || position_ - block_begin_ > block_.size()) return {};
  return block_.substr(static_cast<std::size_t>(position_ - block_begin_), bytes);
}

void ByteStream::skip(std::uint64_t bytes) {
  position_ += std::min(bytes, left());
}

void ByteStream::seek(std::uint64_t position) {
  position_ = std::min(position, end_);
}

void ByteStream::read_block(std::size_t bytes) {
  if (file_ < 0) return;
  bytes = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, left()));
  char* const memory = buffer_.room(bytes);
  std::size_t read = 0;
  while (read < bytes) {
    const ssize_t more = ::pread(file_, memory + read, bytes - read, static_cast<off_t>(position_ + read));
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;  // the file was shortened, or the disk fails: as if it ended here
    read += static_cast<std::size_t>(more);
  }
  block_ = {memory, read};
  block_begin_ = position_;
}

}  // namespace aisle
