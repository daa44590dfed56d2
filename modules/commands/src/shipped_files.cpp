#include "aisle/commands/shipped_files.hpp"

#include <system_error>

namespace aisle {
namespace {

namespace fs = std::filesystem;

/// Built programs are in build/PRESET/bin of the source tree, installed ones in bin beside share.
constexpr int kLevelsUp = 4;

}  // namespace

std::filesystem::path shipped_or_own(const std::string& kind, const std::string& name) {
  std::error_code error;
  const bool is_word = !name.empty() && name.find('/') == std::string::npos;
  if (!is_word || fs::exists(name, error)) return name;
  const std::string file = name.ends_with(".yaml") ? name : name + ".yaml";
  fs::path directory = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int level = 0; level < kLevelsUp && !error; ++level, directory = directory.parent_path()) {
    for (const fs::path& holder : {directory, directory / "share" / "aisle"}) {
      if (fs::path shipped = holder / kind / file; fs::exists(shipped, error)) return shipped;
    }
    error.clear();
  }
  return name;
}

}  // namespace aisle
