#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// What is wrong with a truncated or corrupted PNG or JPEG, found before any decoder sees it: PNG by its
/// checksums, JPEG by its end marker. nullopt: nothing, or another format.
std::optional<std::string> image_damage(std::string_view bytes);

}  // namespace aisle
