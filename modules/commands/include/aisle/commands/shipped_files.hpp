#pragma once

#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"

namespace aisle {

/// The file that `name` means: a path as it stands, or the shipped file of that name ("mini" or "mini.yaml")
/// in the directory `kind` ("vehicles"), looked for beside the running program, where it was built or
/// installed. A file of one's own goes before a shipped one. A word that is neither is refused, with the
/// names that there are.
Result<std::filesystem::path> shipped_or_own(const std::string& kind, const std::string& name);

/// The same, and what `read` finds in the file: read_world, read_vehicle, read_scenario.
template <class Read>
auto read_shipped_or_own(const std::string& kind, const std::string& name, Read read)
    -> decltype(read(std::filesystem::path())) {
  const auto file = shipped_or_own(kind, name);
  if (!file) return file.problems();
  return read(*file);
}

/// The folder of the live page as it was built or installed; empty if it was not.
std::filesystem::path shipped_page();

}  // namespace aisle
