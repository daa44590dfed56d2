#pragma once
/// Scenario files: the faults of a simulated run; see docs/formats/scenario.md.

#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/simulation/scenario.hpp"

namespace aisle {

/// Reads a scenario file; all problems are reported together, each with its line and key.
Result<Scenario> read_scenario(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Scenario> parse_scenario(const std::string& text, const std::string& name);

}  // namespace aisle
