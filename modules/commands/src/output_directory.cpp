#include "aisle/commands/output_directory.hpp"

#include <unistd.h>

namespace aisle {
namespace fs = std::filesystem;

Result<OutputDirectory> OutputDirectory::open(const fs::path& directory, bool force,
                                              const std::vector<std::string>& names) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) return Problem{{directory.string()}, "cannot be made: " + error.message()};
  if (!fs::is_directory(directory, error)) return Problem{{directory.string()}, "is not a directory"};
  if (::access(directory.c_str(), W_OK | X_OK) != 0) return Problem{{directory.string()}, "cannot be written to"};
  if (!force) {
    Problems existing;
    for (const std::string& name : names) {
      if (fs::exists(directory / name)) {
        existing.push_back({{(directory / name).string()}, "exists already; --force replaces it"});
      }
    }
    if (!existing.empty()) return existing;
  }
  return OutputDirectory(directory);
}

}  // namespace aisle
