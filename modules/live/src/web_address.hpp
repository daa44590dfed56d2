#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// "/a/b?c=d" -> "/a/b"
std::string_view path_of(std::string_view target);

/// The value of a key in the query, percent-decoded; empty if there is none.
std::string query_value(std::string_view target, std::string_view key);

/// "%20" -> " "; nullopt if a percent sign is not followed by two hexadecimal digits.
std::optional<std::string> percent_decoded(std::string_view text);

/// The file that a path names below a folder; nullopt if the path could lead elsewhere or to a hidden file.
/// Symbolic links are followed only within the folder.
std::optional<std::filesystem::path> file_below(const std::filesystem::path& folder, std::string_view path);

/// Letters, digits, "-", "_" and ".", at most 64, not beginning with a dot.
bool is_plain_name(std::string_view name);

/// "text/html" and so on, by the file's extension.
std::string media_type(const std::filesystem::path& file);

}  // namespace aisle
