#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace aisle {

/// Removes a former file first: writing over it would wait for the disk.
inline void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace aisle
