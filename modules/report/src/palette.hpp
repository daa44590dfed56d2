#pragma once
/// Colours shared by all pictures.

#include "canvas.hpp"

namespace aisle {

inline constexpr Color kPaper{1, 1, 1};
inline constexpr Color kInk{0.13, 0.17, 0.22};
inline constexpr Color kQuietInk{0.42, 0.47, 0.53};

}  // namespace aisle
