#include "aisle/commands/output_directory.hpp"

#include <unistd.h>

#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

Problems in_the_path(const fs::path& directory, bool force, const std::vector<std::string>& names) {
  Problems problems;
  for (const std::string& name : names) {
    const fs::path path = directory / name;
    if (fs::is_directory(path)) {
      problems.push_back({{path.string()}, "is a directory where a file is to be written"});
    } else if (!force && fs::exists(path)) {
      problems.push_back({{path.string()}, "exists already; --force replaces it"});
    }
  }
  return problems;
}

/// This directory and its parents that do not exist, innermost first.
std::vector<fs::path> missing_of(const fs::path& directory) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path path = directory; !path.empty() && !fs::exists(path, error); path = path.parent_path())
    missing.push_back(path);
  return missing;
}

Problems write_beside(const fs::path& directory, const std::vector<OutputFile>& files) {
  std::error_code error;
  fs::create_directory(directory, error);
  if (error) return {{{directory.string()}, "cannot be made: " + error.message()}};
  for (const OutputFile& file : files) {
    if (Problems problems = write_whole_file(directory / file.name, file.bytes); !problems.empty())
      return problems;
  }
  return {};
}

}  // namespace

Result<OutputDirectory> OutputDirectory::open(const fs::path& directory, bool force,
                                              const std::vector<std::string>& names) {
  if (directory.empty()) return Problem{{"--out"}, "names no directory"};
  std::error_code error;
  std::vector<fs::path> missing = missing_of(directory);
  fs::create_directories(directory, error);
  OutputDirectory opened(directory, std::move(missing));
  if (error) return Problem{{directory.string()}, "cannot be made: " + error.message()};
  if (!fs::is_directory(directory, error)) return Problem{{directory.string()}, "is not a directory"};
  if (::access(directory.c_str(), W_OK | X_OK) != 0)
    return Problem{{directory.string()}, "cannot be written to"};
  fs::remove_all(opened.unfinished(), error);  // of a run that was killed while it wrote
  if (const Problems problems = in_the_path(directory, force, names); !problems.empty()) return problems;
  return opened;
}

OutputDirectory::~OutputDirectory() {
  std::error_code error;
  for (const fs::path& made : made_) {
    fs::remove(made, error);
    if (error) return;
  }
}

Result<std::optional<OutputDirectory>> OutputDirectory::open_if_named(const fs::path& directory, bool force,
                                                                      const std::vector<std::string>& names) {
  if (directory.empty()) return std::optional<OutputDirectory>();
  auto opened = open(directory, force, names);
  if (!opened) return opened.problems();
  return std::optional<OutputDirectory>(std::move(opened).value());
}

Result<std::map<std::string, std::string>> OutputDirectory::write(
    const std::vector<OutputFile>& files) const {
  Problems problems = write_beside(unfinished(), files);
  std::map<std::string, std::string> paths;
  std::error_code error;
  for (auto file = files.begin(); problems.empty() && file != files.end(); ++file) {
    paths[file->role] = path(file->name).string();
    fs::rename(unfinished() / file->name, path(file->name), error);
    if (error)
      problems.push_back({{path(file->name).string()}, "cannot be put in place: " + error.message()});
  }
  fs::remove_all(unfinished(), error);
  if (!problems.empty()) return problems;
  return paths;
}

}  // namespace aisle
