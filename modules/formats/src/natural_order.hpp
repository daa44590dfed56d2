#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace aisle {

/// Whether `a` comes before `b` where runs of digits count as numbers: "frame_9" before "frame_10".
bool is_before_naturally(std::string_view a, std::string_view b);

/// The files of a folder that are wanted, in natural order of their names. Hidden files, such as the `._*`
/// that macOS leaves, are none.
std::vector<std::filesystem::path> files_in_natural_order(
    const std::filesystem::path& folder, const std::function<bool(const std::filesystem::path&)>& is_wanted);

}  // namespace aisle
