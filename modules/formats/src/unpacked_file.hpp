#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"

namespace aisle {

struct UnpackedFile {
  std::string bytes;
  std::string damage = {};  ///< why the file ends here though more was packed; empty: it is whole
  bool is_bomb = false;     ///< it ends here because too little stands for too much
};

/// The bytes of a file; gzip and bzip2 are told by content and unpacked. Of a packed file that is cut off or
/// damaged, what comes before. What InputFile does not open, a file of which nothing can be unpacked, more than
/// `max_bytes`, or a file that unpacks to absurdly more than it has is a problem.
Result<UnpackedFile> read_unpacked_file(const std::filesystem::path& path,
                                        std::size_t max_bytes = std::size_t{2} << 30);

/// The first `max_bytes` of the same, or fewer.
Result<std::string> read_unpacked_head(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace aisle
