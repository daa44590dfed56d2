#pragma once

#include <string>
#include <string_view>

namespace aisle {

/// How to get an element of GStreamer that is not installed: a sentence that names its Debian package.
std::string how_to_install(std::string_view element);

}  // namespace aisle
