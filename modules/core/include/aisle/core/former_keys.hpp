#pragma once
/// Keys of parameter, world and building files as release 0.1 named them. They are still read; release 0.3
/// may drop them, a building's with versions 1 and 2 of its format.

#include <string>
#include <string_view>

namespace aisle {

/// The present name of a key: each renamed part between dots is replaced, so "gates.doubt_m" becomes
/// "frontiers.uncertain_m". A key without such a part is returned unchanged.
std::string present_key(std::string_view former_key);

/// The name that a key without dots had before; the key itself if it never had another.
std::string_view former_key(std::string_view present_key);

}  // namespace aisle
