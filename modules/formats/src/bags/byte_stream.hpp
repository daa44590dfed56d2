#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// A number as little-endian bytes hold it.
/// @param bytes  at least offset + sizeof(Number)
template <class Number>
Number number_at(std::string_view bytes, std::size_t offset = 0) {
  Number number{};
  std::memcpy(&number, bytes.data() + offset, sizeof(number));
  return number;
}

/// Memory whose size grows on demand. It is not set to zero: a size that a file only claims costs nothing.
class Buffer {
 public:
  /// At least `bytes` bytes; what was there before is lost.
  char* room(std::size_t bytes);

 private:
  std::unique_ptr<char[]> memory_;
  std::size_t bytes_ = 0;
};

/// Bytes that are read from front to back: those of a file, by blocks, or those of an unpacked chunk.
class ByteStream {
 public:
  ByteStream() = default;
  /// The bytes must outlive the stream.
  explicit ByteStream(std::string_view bytes) : block_(bytes), end_(bytes.size()) {}
  static Result<ByteStream> open(const std::filesystem::path& path);

  ByteStream(ByteStream&& other) noexcept;
  ByteStream& operator=(ByteStream&& other) noexcept;
  ~ByteStream();

  std::uint64_t position() const { return position_; }
  std::uint64_t size() const { return end_; }
  std::uint64_t left() const { return end_ - position_; }

  /// The next bytes, without passing them; fewer at the end of the stream. Valid until the next call.
  std::string_view peek(std::size_t bytes);
  /// Passes bytes without reading them; at most to the end.
  void skip(std::uint64_t bytes);
  void seek(std::uint64_t position);

 private:
  void read_block(std::size_t bytes);

  int file_ = -1;           ///< none: all bytes are in block_
  Buffer buffer_;           ///< of a file's block
  std::string_view block_;  ///< the bytes from block_begin_ on
  std::uint64_t block_begin_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace aisle
