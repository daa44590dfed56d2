#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz_input.hpp"

namespace aisle {

/// The fuzzer's input as a file whose name ends so, in a memory file system if there is one. The next one of
/// this process replaces it.
inline std::filesystem::path fuzz_file(const std::string& ending, const std::uint8_t* bytes,
                                       std::size_t size) {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  const auto base =
      std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
  const auto path = base / ("aisle-fuzz-" + std::to_string(::getpid()) + ending);
  std::ofstream(path, std::ios::binary) << fuzz_text(bytes, size);
  return path;
}

}  // namespace aisle
