#pragma once
/// Keys with their times, for driving by hand without hands. docs/formats/keys.md specifies the format.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/simulation/operators/key_script.hpp"

namespace aisle {

/// Reads "FROM[-TO] KEY [LABEL]" lines; `name` stands for the file in problems.
Result<std::vector<TimedKey>> parse_key_script(std::string_view text, const std::string& name);

}  // namespace aisle
