#include "aisle/formats/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

namespace aisle {
namespace fs = std::filesystem;

Result<std::string> read_whole_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return Problem{{path.string()}, "no such file"};
  if (fs::is_directory(status)) return Problem{{path.string()}, "is a directory, not a file"};

  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) return Problem{{path.string()}, std::string("cannot be opened: ") + std::strerror(errno)};
  gzbuffer(file.get(), 1 << 17);
  std::string bytes;
  std::size_t used = 0;
  while (true) {
    if (bytes.size() < used + (1 << 17)) bytes.resize(std::max<std::size_t>(2 * bytes.size(), 1 << 20));
    const int count = gzread(file.get(), bytes.data() + used,
                             static_cast<unsigned>(std::min<std::size_t>(bytes.size() - used, 1 << 30)));
    int code = Z_OK;
    const char* message = gzerror(file.get(), &code);
    if (count < 0 || (code != Z_OK && code != Z_STREAM_END)) {
      const std::string why = code == Z_BUF_ERROR ? "the gzip stream is cut off" : message;
      return Problem{{path.string()}, "cannot be read: " + why};
    }
    used += static_cast<std::size_t>(count);
    if (used > max_bytes) {
      return Problem{{path.string()}, "is larger than " + std::to_string(max_bytes >> 20) + " MiB unpacked"};
    }
    if (count == 0) break;
  }
  bytes.resize(used);
  return bytes;
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
