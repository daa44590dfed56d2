#pragma once

#include <chrono>

namespace aisle {

/// For machines that do much else: nothing in these tests takes so long.
inline constexpr std::chrono::seconds kPatience(60);

}  // namespace aisle
