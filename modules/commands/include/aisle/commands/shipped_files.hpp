#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

/// Resolves `name` to a file. A name with a slash, or of an existing file, is taken as a path; any other must
/// be that of a shipped file ("mini" or "mini.yaml") in the directory `kind` ("vehicles") beside the running
/// program, where it was built or installed. An unknown name is a problem that lists the shipped names.
Result<std::filesystem::path> shipped_or_own(const std::string& kind, const std::string& name);

/// Resolves `name` and reads the file with `read`: read_world, read_vehicle or read_scenario.
template <class Read>
auto read_shipped_or_own(const std::string& kind, const std::string& name, Read read)
    -> decltype(read(std::filesystem::path())) {
  const auto file = shipped_or_own(kind, name);
  if (!file) return file.problems();
  return read(*file);
}

struct ShippedFile {
  std::string name;         ///< as verbs take it
  std::string description;  ///< the first sentence of the comment at its top; empty: there is none
};

/// The shipped files of a kind, by name; empty if there are none.
std::vector<ShippedFile> shipped_files(const std::string& kind);

/// The folder of the live page, built or installed; empty if there is none.
std::filesystem::path shipped_page();

}  // namespace aisle
