#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace aisle {

/// Every file of a folder: its bytes, and when it was last written.
using FolderState = std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>>;

inline FolderState state_of_folder(const std::filesystem::path& folder) {
  FolderState state;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    state[entry.path().filename().string()] = {std::string(std::istreambuf_iterator<char>(file), {}),
                                               entry.last_write_time()};
  }
  return state;
}

/// Removes a former file first: writing over it would wait for the disk.
inline void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace aisle
