#pragma once

#include <filesystem>
#include <string>

namespace aisle {

/// The file that `name` means: a path as it stands if there is something, else the shipped file of that name
/// ("mini" or "mini.yaml") in the directory `kind` ("vehicles"), looked for beside the running program, where
/// it was built or installed. If there is neither, the path as it stands.
std::filesystem::path shipped_or_own(const std::string& kind, const std::string& name);

/// The folder of the live page as it was built or installed; empty if it was not.
std::filesystem::path shipped_page();

}  // namespace aisle
