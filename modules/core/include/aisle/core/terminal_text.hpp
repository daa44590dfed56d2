#pragma once

#include <string>
#include <string_view>

namespace aisle {

/// The text as a terminal may show it: line ends and tabs stay; other control characters, marks that turn the
/// direction of writing, and bytes that are no UTF-8 become `\x1b`, `\u202e` and `\xff`. Names and words of
/// files may hold what moves the cursor, sets the window's title or hides a warning.
std::string terminal_text(std::string_view text);

}  // namespace aisle
