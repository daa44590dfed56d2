#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// Writes a building file beside the earlier ones of its name, never over one: "lab", "lab-2", "lab-3", ...
/// What the reader of building files refuses is not written.
/// @param name  of any version
/// @return the new version's name, without folder and ending
Result<std::string> keep_building_version(const std::filesystem::path& folder, std::string_view name,
                                          std::string_view text);

}  // namespace aisle
