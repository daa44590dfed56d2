#include "shared_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace aisle {
namespace {

constexpr int kLockTries = 3000;
constexpr std::chrono::milliseconds kBetweenLockTries{10};

/// The system's question or order for one byte's lock. It belongs to the open file, not to the process.
struct ::flock byte_lock(off_t byte, short kind) {
  struct ::flock lock {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

}  // namespace

Result<SharedFile> SharedFile::open(const std::filesystem::path& path) {
  const int mode = O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK;
  SharedFile file(path, ::open(path.c_str(), mode, 0666));  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (file.descriptor_ < 0) return file.problem("cannot be opened");
  struct ::stat status {};
  if (::fstat(file.descriptor_, &status) != 0) return file.problem("cannot be looked at");
  if (!S_ISREG(status.st_mode)) return Problem{{path.string()}, "is no regular file"};
  return file;
}

SharedFile::SharedFile(SharedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

SharedFile::~SharedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Problem SharedFile::problem(const char* what) const {
  return {{path_.string()}, fmt::format("{}: {}", what, std::strerror(errno))};
}

Result<bool> SharedFile::lock(off_t byte, Lock kind) const {
  auto lock = byte_lock(byte, kind == Lock::kShared ? F_RDLCK : F_WRLCK);
  while (::fcntl(descriptor_, F_OFD_SETLK, &lock) != 0) {  // NOLINT(cppcoreguidelines-pro-type-vararg)
    if (errno == EAGAIN || errno == EACCES) return false;
    if (errno != EINTR) return problem("its file system gives no locks");
  }
  return true;
}

Problems SharedFile::wait_for_lock(off_t byte, Lock kind) const {
  for (int tries = 0; tries < kLockTries; ++tries) {
    const Result<bool> is_locked = lock(byte, kind);
    if (!is_locked) return is_locked.problems();
    if (*is_locked) return {};
    std::this_thread::sleep_for(kBetweenLockTries);
  }
  return {{{path_.string()}, "is locked by a process that does not answer"}};
}

void SharedFile::unlock(off_t byte) const {
  auto lock = byte_lock(byte, F_UNLCK);
  ::fcntl(descriptor_, F_OFD_SETLK, &lock);  // NOLINT(cppcoreguidelines-pro-type-vararg)
}

Result<off_t> SharedFile::size() const {
  struct ::stat status {};
  if (::fstat(descriptor_, &status) != 0) return problem("cannot be looked at");
  return status.st_size;
}

Result<std::string> SharedFile::read_from(off_t begin, std::size_t bytes_max) const {
  const auto end = size();
  if (!end) return end.problems();
  const auto wanted = static_cast<std::size_t>(std::max<off_t>(*end - begin, 0));
  if (wanted > bytes_max) return Problem{{path_.string()}, fmt::format("is longer than {} bytes", bytes_max)};
  std::string bytes(wanted, '\0');
  std::size_t read = 0;
  while (read < wanted) {
    const ssize_t taken =
        ::pread(descriptor_, bytes.data() + read, wanted - read, begin + static_cast<off_t>(read));
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0) return problem("cannot be read");
    if (taken == 0) break;
    read += static_cast<std::size_t>(taken);
  }
  bytes.resize(read);
  return bytes;
}

Problems SharedFile::truncate(off_t size) const {
  if (::ftruncate(descriptor_, size) == 0) return {};
  return {problem("cannot be cut")};
}

Problems SharedFile::append(const std::string& bytes) const {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return {problem("cannot be written")};
    written += static_cast<std::size_t>(count);
  }
  if (::fdatasync(descriptor_) == 0) return {};
  return {problem("cannot be written")};
}

bool SharedFile::is_replaced() const {
  struct ::stat ours {
  }, named{};
  return ::fstat(descriptor_, &ours) != 0 || ::stat(path_.c_str(), &named) != 0 ||
         ours.st_ino != named.st_ino || ours.st_dev != named.st_dev;
}

}  // namespace aisle
