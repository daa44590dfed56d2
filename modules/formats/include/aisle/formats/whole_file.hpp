#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// The bytes of a regular file or of standard input (/dev/stdin); gzip and bzip2 are unpacked. A missing or
/// unreadable file, a directory, a named pipe, a device, a socket, a truncated or damaged packed stream, more
/// than `max_bytes` unpacked bytes, or a stream that unpacks to absurdly more than it has is a problem.
Result<std::string> read_whole_file(const std::filesystem::path& path,
                                    std::size_t max_bytes = std::size_t{128} << 20);

/// Writes all bytes or nothing: to a temporary file beside `path`, synced, then renamed onto it.
/// Empty on success.
Problems write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace aisle
