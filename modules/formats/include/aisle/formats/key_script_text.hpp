#pragma once
/// Key presses with their times: they replace the keyboard when driving by hand. See docs/formats/keys.md.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/simulation/operators/key_script.hpp"

namespace aisle {

/// Reads "FROM[-TO] KEY [LABEL]" lines; `name` is the file name in problems.
Result<std::vector<TimedKey>> parse_key_script(std::string_view text, const std::string& name);

}  // namespace aisle
