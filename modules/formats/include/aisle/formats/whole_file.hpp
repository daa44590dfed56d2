#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// The bytes of a file; gzip files are unpacked. A missing or unreadable file, a directory, a truncated or
/// damaged gzip stream, or more than `max_bytes` unpacked bytes is a problem.
Result<std::string> read_whole_file(const std::filesystem::path& path,
                                    std::size_t max_bytes = std::size_t{2} << 30);

/// Writes all bytes or nothing: to a temporary file beside `path`, synced, then renamed onto it.
/// Empty on success.
Problems write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace aisle
