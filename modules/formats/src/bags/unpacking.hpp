#pragma once
/// The compressions that bags use.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "bags/byte_stream.hpp"

namespace aisle {

/// The largest chunk or message that is unpacked.
inline constexpr std::uint64_t kUnpackedMax_bytes = std::uint64_t{1} << 30;

bool is_compression(std::string_view name);

/// Unpacks as much as the packed bytes hold: all of it, or what comes before a cut or damage.
/// @param compression  one of is_compression(): "zstd", "lz4" (frames) or "bz2"
/// @param size         of the unpacked bytes, as stated; at most kUnpackedMax_bytes
/// @return at most `size` bytes, in `buffer`
std::string_view unpacked(std::string_view compression, std::string_view packed, std::size_t size,
                          Buffer& buffer);

/// Whether the bytes begin as a zstd frame does.
bool is_zstd(std::string_view bytes);

/// A message that was packed by itself. Empty if it is damaged or larger than kUnpackedMax_bytes.
std::string_view unpacked_message(std::string_view packed, Buffer& buffer);

/// Unpacks a .zstd file, as far as it goes.
/// @return whether it is whole; a problem if the other file cannot be written, or would fill the disk
Result<bool> unpack_file(const std::filesystem::path& packed, const std::filesystem::path& to);

}  // namespace aisle
