#include "aisle/commands/shipped_files.hpp"

#include <initializer_list>
#include <system_error>

namespace aisle {
namespace {

namespace fs = std::filesystem;

/// Built programs are in build/PRESET/bin of the source tree, installed ones in bin beside share.
constexpr int kLevelsUp = 4;

/// The first of these that is there, in the program's directory or one above it; empty if none is.
fs::path beside_program(std::initializer_list<fs::path> relative) {
  std::error_code error;
  fs::path directory = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int level = 0; level < kLevelsUp && !error; ++level, directory = directory.parent_path()) {
    for (const fs::path& path : relative) {
      if (fs::path found = directory / path; fs::exists(found, error)) return found;
    }
    error.clear();
  }
  return {};
}

}  // namespace

std::filesystem::path shipped_or_own(const std::string& kind, const std::string& name) {
  std::error_code error;
  const bool is_word = !name.empty() && name.find('/') == std::string::npos;
  if (!is_word || fs::exists(name, error)) return name;
  const std::string file = name.ends_with(".yaml") ? name : name + ".yaml";
  const fs::path shipped = beside_program({fs::path(kind) / file, fs::path("share/aisle") / kind / file});
  return shipped.empty() ? fs::path(name) : shipped;
}

std::filesystem::path shipped_page() {
  return beside_program({"web/dist/index.html", "share/aisle/web/index.html"}).parent_path();
}

}  // namespace aisle
