#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "aisle/core/result.hpp"

namespace aisle {

/// A file open for reading whose bytes come to an end: a regular file, or the program's own standard input.
/// Opening a named pipe, a device or a socket could wait for ever.
class InputFile {
 public:
  /// Never waits. What is missing, is a folder or another kind of thing, or may not be read is a problem.
  static Result<InputFile> open(const std::filesystem::path& path);
  InputFile(InputFile&& other) noexcept : file_(other.file_), bytes_(other.bytes_) { other.file_ = -1; }
  InputFile& operator=(InputFile&& other) = delete;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  /// The file's size when it was opened; 0 of standard input and where the system states none.
  std::uint64_t bytes() const { return bytes_; }
  /// @return how many bytes were read; 0: the file ends; -1: errno says why not
  ssize_t read(char* to, std::size_t bytes);
  /// Gives the open file away, to be closed by the caller.
  int release();

 private:
  InputFile(int file, std::uint64_t bytes) : file_(file), bytes_(bytes) {}

  int file_;
  std::uint64_t bytes_;
};

}  // namespace aisle
