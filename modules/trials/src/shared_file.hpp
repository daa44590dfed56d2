#pragma once
/// A file of lines to which several processes add, on one machine or on several that reach its file system.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"

namespace aisle {

/// Single bytes of it can be locked. The system lets go of a lock when the process that took it dies, so no
/// lock outlives its holder. The bytes may lie beyond the file's end. Problems: as the system says them, with
/// the file's name.
class SharedFile {
 public:
  enum class Lock { kShared, kExclusive };

  /// Makes the file if there is none. Problem: it is no regular file; it cannot be opened.
  static Result<SharedFile> open(const std::filesystem::path& path);

  SharedFile(SharedFile&& other) noexcept;
  SharedFile& operator=(SharedFile&&) = delete;
  ~SharedFile();

  const std::filesystem::path& path() const { return path_; }

  /// Takes a byte's lock, or changes its kind. @return false: another process holds one against it
  Result<bool> lock(off_t byte, Lock kind) const;
  /// Waits for a lock that its holders never keep for long.
  Problems wait_for_lock(off_t byte, Lock kind) const;
  void unlock(off_t byte) const;

  /// The bytes from `begin` to the file's end, of which there may be at most `bytes_max`.
  Result<std::string> read_from(off_t begin, std::size_t bytes_max) const;
  Result<off_t> size() const;
  Problems truncate(off_t size) const;
  /// Adds bytes to the end; they are on the disk when it returns.
  Problems append(const std::string& bytes) const;
  /// Whether the path names another file by now, or none.
  bool is_replaced() const;

 private:
  SharedFile(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  Problem problem(const char* what) const;

  std::filesystem::path path_;
  int descriptor_;  ///< -1: moved from
};

}  // namespace aisle
