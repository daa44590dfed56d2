#pragma once

#include <cstddef>
#include <string_view>

namespace aisle {

/// How many characters must be added, removed or replaced to make one text of the other (Levenshtein).
/// O(length of a * length of b)
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace aisle
