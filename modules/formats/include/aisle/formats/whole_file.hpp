#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// The bytes of a file; gzip'd files are unpacked. A missing or unreadable file, a directory, a gzip stream
/// that is cut off or damaged, or more than `max_bytes` unpacked is a problem.
Result<std::string> read_whole_file(const std::filesystem::path& path,
                                    std::size_t max_bytes = std::size_t{2} << 30);

/// Writes all bytes or nothing: to a temporary file beside `path`, synced, then renamed onto it.
/// Empty on success.
Problems write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace aisle
