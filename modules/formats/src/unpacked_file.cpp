#include "unpacked_file.hpp"

#include <bzlib.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include "file_limits.hpp"
#include "input_file.hpp"

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

/// The bytes at hand that stand for so many packed ones: more than any file of measurements or walls has.
bool is_bomb(std::size_t unpacked, std::size_t packed) {
  return unpacked > kUnpackedFreely_bytes && unpacked / kUnpackedRatioMax > packed;
}

/// Unpacks until `max_bytes` are there, the input ends, or it makes no sense. Several packed streams one
/// after the other are one; what follows the last is ignored.
template <class Stream>
UnpackedFile unpack(InputFile& file, std::string_view head, std::size_t max_bytes) {
  Stream packed;
  UnpackedFile unpacked;
  std::vector<char> input(kUnpackChunk), output(kUnpackChunk);
  std::copy(head.begin(), head.end(), input.begin());
  packed.set_input(input.data());
  packed.stream.avail_in = static_cast<unsigned>(head.size());
  std::size_t read = head.size();
  bool between_streams = false;
  bool has_more_output = false;
  while (unpacked.bytes.size() < max_bytes) {
    if (packed.stream.avail_in == 0 && !has_more_output) {
      const ssize_t count = file.read(input.data(), input.size());
      if (count <= 0) {
        if (!between_streams) unpacked.damage = std::string("the ") + Stream::kName + " stream is cut off";
        break;
      }
      packed.set_input(input.data());
      packed.stream.avail_in = static_cast<unsigned>(count);
      read += static_cast<std::size_t>(count);
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
    if (is_bomb(unpacked.bytes.size(), read - packed.stream.avail_in)) {
      unpacked.is_bomb = true;
      break;
    }
    between_streams = progress == Unpacking::kStreamEnds;
    has_more_output = !between_streams && packed.stream.avail_out == 0;
    if (progress != Unpacking::kDamaged) continue;
    unpacked.damage = std::string("the ") + Stream::kName + " stream is damaged";
    break;
  }
  return unpacked;
}

UnpackedFile read_plain(InputFile& file, std::string_view head, std::size_t max_bytes) {
  UnpackedFile plain;
  plain.bytes.reserve(std::min<std::size_t>(file.bytes(), max_bytes));
  plain.bytes = head;
  std::vector<char> input(kUnpackChunk);
  ssize_t count = 1;
  while (plain.bytes.size() < max_bytes && (count = file.read(input.data(), input.size())) > 0)
    plain.bytes.append(input.data(), static_cast<std::size_t>(count));
  if (count < 0) plain.damage = std::strerror(errno);
  return plain;
}

/// At least `max_bytes` if the file has them.
Result<UnpackedFile> unpacked_up_to(const fs::path& path, std::size_t max_bytes) {
  auto file = InputFile::open(path);
  if (!file) return file.problems();
  std::array<char, 4> first{};
  std::size_t count = 0;
  for (ssize_t more = 1; more > 0 && count < first.size(); count += static_cast<std::size_t>(more)) {
    more = file->read(first.data() + count, first.size() - count);
    if (more < 0) return Problem{{path.string()}, std::string("cannot be read: ") + std::strerror(errno)};
  }
  const std::string_view head(first.data(), count);
  UnpackedFile unpacked = head.starts_with(kGzipMagic)    ? unpack<GzipStream>(*file, head, max_bytes)
                          : head.starts_with(kBzip2Magic) ? unpack<Bzip2Stream>(*file, head, max_bytes)
                                                          : read_plain(*file, head, max_bytes);
  if (unpacked.bytes.empty() && !unpacked.damage.empty()) {
    return Problem{{path.string()}, "cannot be read: " + unpacked.damage};
  }
  return unpacked;
}

}  // namespace

Result<UnpackedFile> read_unpacked_file(const fs::path& path, std::size_t max_bytes) {
  Result<UnpackedFile> unpacked = unpacked_up_to(path, max_bytes + 1);
  if (unpacked && unpacked->is_bomb) {
    return Problem{{path.string()},
                   fmt::format("holds more than {} bytes for every packed one: so much is not unpacked",
                               kUnpackedRatioMax)};
  }
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
