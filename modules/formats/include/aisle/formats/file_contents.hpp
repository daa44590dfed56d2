#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// What a file is by its first bytes, for a message: "a ROS 1 bag". No value: a text or bytes of a kind that
/// has no mark of its own.
std::optional<std::string> known_contents(std::string_view head);

/// The same, with words also for what has no mark.
std::string describe_contents(std::string_view head);

bool is_tar_archive(std::string_view head);

}  // namespace aisle
