#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace aisle {

/// A module as its CMakeLists.txt declares it; only modules of aisle are named, not libraries.
struct Module {
  std::set<std::string> uses;            ///< what its public headers may include
  std::set<std::string> uses_privately;  ///< what only its sources may include
};

using Modules = std::map<std::string, Module>;

/// Lines "name USES aisle::a Other::b USES_PRIVATELY aisle::c".
Modules read_modules(const std::filesystem::path& file);

/// The modules whose headers are reachable from `direct`: these, and what their public headers use.
std::set<std::string> in_reach(const Modules& modules, const std::set<std::string>& direct);

struct SourceLine {
  std::filesystem::path file;
  int number = 0;  ///< 1-based
  std::string text;
};

/// "file:line: text"
std::string to_string(const SourceLine& line);

/// The lines of all C++ files below a directory, without `//` comments.
std::vector<SourceLine> source_lines(const std::filesystem::path& directory);

}  // namespace aisle
