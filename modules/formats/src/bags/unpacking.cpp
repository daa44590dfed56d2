#include "bags/unpacking.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <fstream>
#include <memory>
#include <vector>

namespace aisle {
namespace fs = std::filesystem;

namespace {

struct FreeZstd {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};
using ZstdContext = std::unique_ptr<ZSTD_DCtx, FreeZstd>;

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

/// @return how many bytes were unpacked
std::size_t unpack_zstd(std::string_view packed, char* to, std::size_t size) {
  static thread_local const ZstdContext context(ZSTD_createDCtx());
  ZSTD_DCtx_reset(context.get(), ZSTD_reset_session_only);
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  ZSTD_outBuffer out{to, size, 0};
  while (in.pos < in.size) {
    const std::size_t before = in.pos + out.pos;
    if (ZSTD_isError(ZSTD_decompressStream(context.get(), &out, &in)) || in.pos + out.pos == before) break;
  }
  return out.pos;
}

std::size_t unpack_lz4(std::string_view packed, char* to, std::size_t size) {
  LZ4F_dctx* created = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&created, LZ4F_VERSION))) return 0;
  const std::unique_ptr<LZ4F_dctx, FreeLz4> context(created);
  const LZ4F_decompressOptions_t options{};
  std::size_t read = 0, written = 0;
  while (read < packed.size()) {
    std::size_t in = packed.size() - read, out = size - written;
    const std::size_t code =
        LZ4F_decompress(context.get(), to + written, &out, packed.data() + read, &in, &options);
    if (LZ4F_isError(code)) break;
    read += in;
    written += out;
    if (code == 0 || in + out == 0) break;
  }
  return written;
}

std::size_t unpack_bz2(std::string_view packed, char* to, std::size_t size) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return 0;
  stream.next_in = const_cast<char*>(packed.data());  // NOLINT: only read
  stream.avail_in = static_cast<unsigned>(packed.size());
  stream.next_out = to;
  stream.avail_out = static_cast<unsigned>(size);
  int code = BZ_OK;
  unsigned before = 0;
  do {
    before = stream.avail_in + stream.avail_out;
    code = BZ2_bzDecompress(&stream);
  } while (code == BZ_OK && stream.avail_in + stream.avail_out < before);
  BZ2_bzDecompressEnd(&stream);
  return size - stream.avail_out;
}

/// What a frame says of its unpacked size; the most that is accepted if it says nothing.
std::size_t zstd_size(std::string_view packed) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_ERROR) return 0;
  if (size == ZSTD_CONTENTSIZE_UNKNOWN) return kUnpackedMax_bytes;
  return size > kUnpackedMax_bytes ? 0 : static_cast<std::size_t>(size);
}

}  // namespace

bool is_compression(std::string_view name) {
  return name == "zstd" || name == "lz4" || name == "bz2";
}

std::string_view unpacked(std::string_view compression, std::string_view packed, std::size_t size,
                          Buffer& buffer) {
  char* const to = buffer.room(size);
  const auto unpack = compression == "zstd" ? unpack_zstd : compression == "lz4" ? unpack_lz4 : unpack_bz2;
  return {to, unpack(packed, to, size)};
}

bool is_zstd(std::string_view bytes) {
  return bytes.substr(0, 4) == "\x28\xB5\x2F\xFD";
}

std::string_view unpacked_message(std::string_view packed, Buffer& buffer) {
  const std::size_t size = zstd_size(packed);
  return size == 0 ? std::string_view() : unpacked("zstd", packed, size, buffer);
}

Result<bool> unpack_file(const fs::path& packed, const fs::path& to) {
  auto bytes = ByteStream::open(packed);
  if (!bytes) return bytes.problems();
  std::ofstream file(to, std::ios::binary);
  const ZstdContext context(ZSTD_createDCtx());
  std::vector<char> block(ZSTD_DStreamOutSize());
  std::error_code error;
  const std::uint64_t room = fs::space(to.parent_path(), error).available / 2;
  std::uint64_t written = 0;
  std::size_t code = 1;
  while (bytes->left() > 0) {
    const std::string_view piece = bytes->peek(ZSTD_DStreamInSize());
    if (piece.empty()) return false;
    ZSTD_inBuffer in{piece.data(), piece.size(), 0};
    ZSTD_outBuffer out{block.data(), block.size(), 0};
    do {
      out.pos = 0;
      code = ZSTD_decompressStream(context.get(), &out, &in);
      if (ZSTD_isError(code)) return false;
      written += out.pos;
      if (written > room) return Problem{{packed.string()}, "unpacked, it would take half of the free disk"};
      if (!file.write(block.data(), static_cast<std::streamsize>(out.pos)))
        return Problem{{to.string()}, "cannot be written"};
    } while (in.pos < in.size || out.pos == out.size);
    bytes->skip(piece.size());
  }
  if (!file.flush()) return Problem{{to.string()}, "cannot be written"};
  return code == 0;
}

}  // namespace aisle
