#include "aisle/commands/shipped_files.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <fstream>
#include <initializer_list>
#include <set>
#include <string_view>
#include <system_error>

namespace aisle {
namespace {

namespace fs = std::filesystem;

/// Built programs are in build/PRESET/bin of the source tree, installed ones in bin beside share; Python's
/// module is in build/PRESET/python/aisle or lib/python3/dist-packages/aisle.
constexpr int kLevelsUp = 5;

/// The file that this code is in: the running program, or a module that it has loaded.
fs::path own_file(std::error_code& error) {
  Dl_info info{};
  void* loaded = nullptr;
  const bool is_known =
      ::dladdr1(reinterpret_cast<const void*>(&own_file), &info, &loaded, RTLD_DL_LINKMAP) != 0;
  const std::string_view name = is_known ? static_cast<const link_map*>(loaded)->l_name : "";
  return name.empty() ? fs::read_symlink("/proc/self/exe", error) : fs::canonical(name, error);
}

/// The first of these that exists, beside this code or in a directory above it; empty if none does.
fs::path beside_program(std::initializer_list<fs::path> relative) {
  std::error_code error;
  fs::path directory = own_file(error).parent_path();
  for (int level = 0; level < kLevelsUp && !error; ++level, directory = directory.parent_path()) {
    for (const fs::path& path : relative) {
      if (fs::path found = directory / path; fs::exists(found, error)) return found;
    }
    error.clear();
  }
  return {};
}

fs::path shipped_folder(const std::string& kind) {
  return beside_program({kind, fs::path("share/aisle") / kind});
}

/// Names of the YAML files in a folder, in order; empty if there is no folder.
std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(folder, error)) {
    if (file.path().extension() == ".yaml") names.insert(file.path().stem().string());
  }
  return names;
}

/// The first sentence of the comment at the top of a file.
std::string first_sentence(const fs::path& file) {
  std::ifstream lines(file);
  std::string comment;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");)
    comment += (comment.empty() ? "" : " ") + line.substr(2);
  const std::size_t end = comment.find(". ");
  if (end != std::string::npos) return comment.substr(0, end);
  return comment.ends_with('.') ? comment.substr(0, comment.size() - 1) : comment;
}

}  // namespace

std::vector<ShippedFile> shipped_files(const std::string& kind) {
  const fs::path folder = shipped_folder(kind);
  std::vector<ShippedFile> files;
  for (const std::string& name : names_in(folder))
    files.push_back({name, first_sentence(folder / (name + ".yaml"))});
  return files;
}

Result<fs::path> shipped_or_own(const std::string& kind, const std::string& name) {
  std::error_code error;
  const bool is_word = !name.empty() && name.find('/') == std::string::npos;
  if (!is_word || fs::exists(name, error)) return fs::path(name);
  const fs::path shipped = shipped_folder(kind);
  const fs::path file = shipped / (name.ends_with(".yaml") ? name : name + ".yaml");
  if (!shipped.empty() && fs::exists(file, error)) return file;
  return Problem{
      {name},
      fmt::format("no such file, nor one of the shipped {}: {}", kind, fmt::join(names_in(shipped), ", "))};
}

std::filesystem::path shipped_page() {
  return beside_program({"web/dist/index.html", "share/aisle/web/index.html"}).parent_path();
}

}  // namespace aisle
