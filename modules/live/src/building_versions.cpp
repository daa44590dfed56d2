#include "aisle/live/building_versions.hpp"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "web_address.hpp"

namespace aisle {
namespace {

constexpr int kVersionsMax = 10'000;

/// "lab-12" -> "lab"
std::string_view without_version(std::string_view name) {
  const std::size_t dash = name.find_last_of('-');
  if (dash == std::string_view::npos || dash == 0 || dash + 1 == name.size()) return name;
  const std::string_view number = name.substr(dash + 1);
  const bool is_number =
      std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_number ? name.substr(0, dash) : name;
}

}  // namespace

Result<std::string> keep_building_version(const std::filesystem::path& folder, std::string_view name,
                                          std::string_view text) {
  if (!is_plain_name(name)) return Problem{{std::string(name)}, "is not a building name"};
  if (const auto building = parse_building(text, std::string(name)); !building) return building.problems();
  const std::string base(without_version(name));
  for (int version = 1; version <= kVersionsMax; ++version) {
    const std::string candidate = version == 1 ? base : base + "-" + std::to_string(version);
    const std::filesystem::path file = folder / (candidate + ".json");
    std::error_code error;
    if (std::filesystem::exists(std::filesystem::symlink_status(file, error))) continue;
    if (Problems problems = write_whole_file(file, text); !problems.empty()) return problems;
    return candidate;
  }
  return Problem{{base}, "has too many versions"};
}

}  // namespace aisle
