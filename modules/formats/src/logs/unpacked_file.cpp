#include "logs/unpacked_file.hpp"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace aisle {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kUnpackChunk = 1 << 17;
constexpr std::string_view kGzipMagic = "\x1f\x8b";
constexpr std::string_view kBzip2Magic = "BZh";

/// What unpacking a piece of input came to.
enum class Unpacking { kMore, kStreamEnds, kDamaged };

struct GzipStream {
  static constexpr const char* kName = "gzip";
  static constexpr std::string_view kMagic = kGzipMagic;
  GzipStream() { inflateInit2(&stream, MAX_WBITS + 16); }
  ~GzipStream() { inflateEnd(&stream); }
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  void restart() { inflateReset(&stream); }
  Unpacking step() {
    const int code = inflate(&stream, Z_NO_FLUSH);
    if (code == Z_STREAM_END) return Unpacking::kStreamEnds;
    return code == Z_OK || code == Z_BUF_ERROR ? Unpacking::kMore : Unpacking::kDamaged;
  }
  void set_input(char* bytes) { stream.next_in = reinterpret_cast<Bytef*>(bytes); }
  void set_output(char* bytes) { stream.next_out = reinterpret_cast<Bytef*>(bytes); }

  z_stream stream = {};
};

struct Bzip2Stream {
  static constexpr const char* kName = "bzip2";
  static constexpr std::string_view kMagic = kBzip2Magic;
  Bzip2Stream() { BZ2_bzDecompressInit(&stream, 0, 0); }
  ~Bzip2Stream() { BZ2_bzDecompressEnd(&stream); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  void restart() {
    const bz_stream kept = stream;
    BZ2_bzDecompressEnd(&stream);
    stream = {};
    BZ2_bzDecompressInit(&stream, 0, 0);
    stream.next_in = kept.next_in;
    stream.avail_in = kept.avail_in;
  }
  Unpacking step() {
    const int code = BZ2_bzDecompress(&stream);
    if (code == BZ_STREAM_END) return Unpacking::kStreamEnds;
    return code == BZ_OK ? Unpacking::kMore : Unpacking::kDamaged;
  }
  void set_input(char* bytes) { stream.next_in = bytes; }
  void set_output(char* bytes) { stream.next_out = bytes; }

  bz_stream stream = {};
};

using InputFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Unpacks until `max_bytes` are there, the input ends, or it makes no sense. Several packed streams one
/// after the other are one; what follows the last is ignored.
template <class Stream>
UnpackedFile unpack(std::FILE* file, std::size_t max_bytes) {
  Stream packed;
  UnpackedFile unpacked;
  std::vector<char> input(kUnpackChunk), output(kUnpackChunk);
  bool between_streams = false;
  bool has_more_output = false;
  while (unpacked.bytes.size() < max_bytes) {
    if (packed.stream.avail_in == 0 && !has_more_output) {
      const std::size_t count = std::fread(input.data(), 1, input.size(), file);
      if (count == 0) {
        if (!between_streams) unpacked.damage = std::string("the ") + Stream::kName + " stream is cut off";
        break;
      }
      packed.set_input(input.data());
      packed.stream.avail_in = static_cast<unsigned>(count);
    }
    if (between_streams) {
      if (static_cast<char>(*packed.stream.next_in) != Stream::kMagic.front()) break;
      packed.restart();
      between_streams = false;
    }
    packed.set_output(output.data());
    packed.stream.avail_out = static_cast<unsigned>(output.size());
    const Unpacking progress = packed.step();
    unpacked.bytes.append(output.data(), output.size() - packed.stream.avail_out);
    between_streams = progress == Unpacking::kStreamEnds;
    has_more_output = !between_streams && packed.stream.avail_out == 0;
    if (progress != Unpacking::kDamaged) continue;
    unpacked.damage = std::string("the ") + Stream::kName + " stream is damaged";
    break;
  }
  return unpacked;
}

UnpackedFile read_unpacked(std::FILE* file, std::size_t max_bytes) {
  UnpackedFile plain;
  std::vector<char> input(kUnpackChunk);
  while (plain.bytes.size() < max_bytes) {
    const std::size_t count = std::fread(input.data(), 1, input.size(), file);
    if (count == 0) break;
    plain.bytes.append(input.data(), count);
  }
  if (std::ferror(file) != 0) plain.damage = std::strerror(errno);
  return plain;
}

/// At least `max_bytes` if the file has them.
Result<UnpackedFile> unpacked_up_to(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return Problem{{path.string()}, "no such file"};
  if (fs::is_directory(status)) return Problem{{path.string()}, "is a directory, not a file"};
  const InputFile file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) return Problem{{path.string()}, std::string("cannot be opened: ") + std::strerror(errno)};

  char head[4] = {};
  const std::size_t count = std::fread(head, 1, sizeof(head), file.get());
  const std::string_view magic(head, count);
  std::rewind(file.get());
  UnpackedFile unpacked = magic.starts_with(kGzipMagic)    ? unpack<GzipStream>(file.get(), max_bytes)
                          : magic.starts_with(kBzip2Magic) ? unpack<Bzip2Stream>(file.get(), max_bytes)
                                                           : read_unpacked(file.get(), max_bytes);
  if (unpacked.bytes.empty() && !unpacked.damage.empty()) {
    return Problem{{path.string()}, "cannot be read: " + unpacked.damage};
  }
  return unpacked;
}

}  // namespace

Result<UnpackedFile> read_unpacked_file(const fs::path& path, std::size_t max_bytes) {
  Result<UnpackedFile> unpacked = unpacked_up_to(path, max_bytes + 1);
  if (unpacked && unpacked->bytes.size() > max_bytes) {
    return Problem{{path.string()}, "is larger than " + std::to_string(max_bytes >> 20) + " MiB unpacked"};
  }
  return unpacked;
}

Result<std::string> read_unpacked_head(const fs::path& path, std::size_t max_bytes) {
  Result<UnpackedFile> unpacked = unpacked_up_to(path, max_bytes);
  if (!unpacked) return unpacked.problems();
  unpacked->bytes.resize(std::min(unpacked->bytes.size(), max_bytes));
  return std::move(unpacked->bytes);
}

}  // namespace aisle
