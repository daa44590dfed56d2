#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// What is wrong with a PNG or JPEG that was cut off or changed, before any decoder meets it: PNG by its
/// checksums, JPEG by its end. nullopt: nothing, or another format.
std::optional<std::string> image_damage(std::string_view bytes);

}  // namespace aisle
