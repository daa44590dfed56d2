#include "input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace aisle {
namespace {

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory, not a file";
  const char* kind = S_ISFIFO(mode) ? "a pipe" : S_ISSOCK(mode) ? "a socket" : "a device";
  return kind;
}

Problem refused(const std::filesystem::path& path, mode_t mode) {
  const char* kind = kind_of(mode);
  if (S_ISDIR(mode)) return {{path.string()}, fmt::format("is {}", kind)};
  return {{path.string()}, fmt::format("is {}; only regular files and standard input are read", kind)};
}

/// Whether a pipe or a socket is the one that the program was started with.
bool is_standard_input(const struct stat& state) {
  struct stat input {};
  if (::fstat(STDIN_FILENO, &input) != 0 || S_ISCHR(state.st_mode)) return false;
  return input.st_dev == state.st_dev && input.st_ino == state.st_ino;
}

}  // namespace

Result<InputFile> InputFile::open(const std::filesystem::path& path) {
  struct stat state {};
  if (::stat(path.c_str(), &state) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return Problem{{path.string()}, "no such file"};
    return Problem{{path.string()}, fmt::format("cannot be opened: {}", std::strerror(errno))};
  }
  const bool is_input = !S_ISREG(state.st_mode) && is_standard_input(state);
  if (!S_ISREG(state.st_mode) && !is_input) return refused(path, state.st_mode);
  const int file = is_input ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                            : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return Problem{{path.string()}, fmt::format("cannot be opened: {}", std::strerror(errno))};
  InputFile input(file, 0);
  if (::fstat(file, &state) != 0 || (!S_ISREG(state.st_mode) && !is_input))
    return refused(path, state.st_mode);  // the path was given another file meanwhile
  if (S_ISREG(state.st_mode)) input.bytes_ = static_cast<std::uint64_t>(state.st_size);
  return input;
}

InputFile::~InputFile() {
  if (file_ >= 0) ::close(file_);
}

ssize_t InputFile::read(char* to, std::size_t bytes) {
  ssize_t count = 0;
  do {
    count = ::read(file_, to, bytes);
  } while (count < 0 && errno == EINTR);
  return count;
}

int InputFile::release() {
  return std::exchange(file_, -1);
}

}  // namespace aisle
