#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// Writes a building file beside the earlier ones of the same name and never overwrites one: "lab", "lab-2",
/// "lab-3", ... Text that read_building() refuses is not written.
/// @param name  of any version
/// @return the new version's name, without folder and extension
Result<std::string> keep_building_version(const std::filesystem::path& folder, std::string_view name,
                                          std::string_view text);

}  // namespace aisle
