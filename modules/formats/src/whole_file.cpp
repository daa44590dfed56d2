#include "aisle/formats/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "unpacked_file.hpp"

namespace aisle {
namespace fs = std::filesystem;

Result<std::string> read_whole_file(const fs::path& path, std::size_t max_bytes) {
  Result<UnpackedFile> file = read_unpacked_file(path, max_bytes);
  if (!file) return file.problems();
  if (!file->damage.empty()) return Problem{{path.string()}, "cannot be read: " + file->damage};
  return std::move(file->bytes);
}

Problems write_whole_file(const fs::path& path, std::string_view bytes) {
  const fs::path unfinished = path.string() + ".part";
  const auto failed = [&](const char* step) {
    const std::string why = std::strerror(errno);
    ::unlink(unfinished.c_str());
    return Problems{{{path.string()}, std::string("cannot be ") + step + ": " + why}};
  };
  const int file = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return failed("created");
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      ::close(file);
      return failed("written");
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  const bool synced = ::fsync(file) == 0;
  if (::close(file) != 0 || !synced) return failed("written");
  if (::rename(unfinished.c_str(), path.c_str()) != 0) return failed("put in place");
  return {};
}

}  // namespace aisle
